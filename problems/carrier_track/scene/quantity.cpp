#include "problems/carrier_track/scene/quantity.h"

#include <charconv>
#include <numbers>

namespace ricochet::carrier_track::inline scene {
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

}  // namespace ricochet::carrier_track::inline scene
