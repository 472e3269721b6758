#include "src/core/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <system_error>

namespace ricochet {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// All digits of a whole number, however large.
std::string bound_in_words(double bound, bool whole) {
  return whole && std::isfinite(bound) ? fmt::format("{:.0f}", bound) : fmt::format("{}", bound);
}

}  // namespace

bool contains(const Range& range, double x) {
  if (range.least == -infinity && range.most == infinity && !range.whole) return true;
  return x >= range.least && x <= range.most && !(range.without_least && x == range.least) &&
         !(range.without_most && x == range.most) && (!range.whole || x == std::floor(x));
}

std::string in_words(const Range& range, std::string_view unit) {
  if (!range.words.empty()) return fmt::format(fmt::runtime(range.words), unit);
  std::string words = fmt::format("a {}number from {} to {}", range.whole ? "whole " : "",
                                  bound_in_words(range.least, range.whole),
                                  bound_in_words(range.most, range.whole));
  if (range.without_least) words += fmt::format(", but not {}", range.least);
  if (range.without_most) words += fmt::format(", but not {}", range.most);
  return words;
}

namespace {

/// A number x of `name` is x * times / over of the unit `of`. Two factors, because dividing by 1000
/// rounds once, and multiplying by 0.001 twice.
struct Unit {
  std::string_view of, name;
  double times, over;
};

constexpr double pi = std::numbers::pi;

/// The units of every dimension; the first of each is the SI unit itself.
constexpr Unit units[] = {
    {"kg", "kg", 1, 1},       {"kg", "g", 1, 1e3},         {"m", "m", 1, 1},
    {"m", "mm", 1, 1e3},      {"m", "cm", 1, 1e2},         {"m", "um", 1, 1e6},
    {"m/s", "m/s", 1, 1},     {"m/s", "mm/s", 1, 1e3},     {"m/s", "cm/s", 1, 1e2},
    {"N", "N", 1, 1},         {"N", "mN", 1, 1e3},         {"N", "kN", 1e3, 1},
    {"s", "s", 1, 1},         {"s", "ms", 1, 1e3},         {"s", "min", 60, 1},
    {"rad", "rad", 1, 1},     {"rad", "deg", pi, 180},     {"rad/s", "rad/s", 1, 1},
    {"rad/s", "rpm", pi, 30}, {"rad/s", "deg/s", pi, 180}, {"rad/s", "Hz", 2 * pi, 1},
    {"kg m", "kg m", 1, 1},   {"kg m", "kg mm", 1, 1e3},   {"kg m", "g m", 1, 1e3},
    {"kg m", "g mm", 1, 1e6}};

}  // namespace

std::vector<std::string_view> units_for(std::string_view unit) {
  std::vector<std::string_view> names;
  for (const Unit& known : units) {
    if (known.of == unit) names.push_back(known.name);
  }
  return names;
}

std::optional<double> quantity(std::string_view text, std::string_view unit) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::size_t blanks = text.find_first_not_of(' ');
  if (blanks == std::string_view::npos) return std::nullopt;
  const std::string_view wanted = text.substr(blanks);
  for (const Unit& known : units) {
    if (known.of == unit && known.name == wanted) return number * known.times / known.over;
  }
  return std::nullopt;
}

std::string numbers_in_words(std::string_view unit) {
  const std::vector<std::string_view> names = units_for(unit);
  if (names.empty()) return "a number";
  return fmt::format("a number [{}], or a text such as \"1 {}\" with a unit of {}", unit,
                     names.back(), fmt::join(names, ", "));
}

}  // namespace ricochet
