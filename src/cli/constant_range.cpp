#include "src/cli/constant_range.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/scene/quantity.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "src/core/number_of_text.h"
#include "src/core/one_line.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

/// The SI unit of a constant, "1" for a number without unit.
std::string unit_of(const std::string& constant) {
  if (constant == "clearance") return "m";
  std::string unit = "1";
  Scene scene;
  const auto visit = [&](const Field& field, const auto&... /*members*/) {
    if (field.key == constant) unit = field.unit;
  };
  visit_scene_fields(visit, scene);
  visit_count_fields(visit, scene);
  return unit;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The name of the unit that a text ends with; empty if it is a plain number.
std::string unit_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return "";
  return std::string(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

std::optional<double> number_of(std::string_view text, const std::string& unit,
                                const std::string& usual) {
  if (const auto number = number_of_text<double>(text)) {
    return usual.empty() ? number : quantity(fmt::format("{} {}", text, usual), unit);
  }
  return quantity(text, unit);
}

}  // namespace

ConstantRange constant_range_of(const std::string& text) {
  const std::string origin = one_line(fmt::format("--over {}", text));
  const std::size_t equal = text.find('='), dots = text.find("..");
  if (equal == std::string::npos || dots == std::string::npos || dots < equal) {
    throw InputError(origin + ": must be CONSTANT=FROM..TO, as in restitution=0.05..0.95");
  }
  ConstantRange range{std::string(trimmed(std::string_view(text).substr(0, equal))), 0, 0, {}};
  try {
    constant_named(Scene{}, range.constant);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--over {}", one_line(error.what())));
  }
  const std::string unit = unit_of(range.constant);
  const std::string_view all = text;
  const std::string_view from = trimmed(all.substr(equal + 1, dots - equal - 1));
  const std::string_view to = trimmed(all.substr(dots + 2));
  const std::string name = unit_in(to);
  const auto lower = number_of(from, unit, name), upper = number_of(to, unit, name);
  if (!lower || !upper) {
    throw InputError(fmt::format(
        "{}: must be two numbers{}", origin,
        unit == "1" ? ""
                    : fmt::format(", with one of the units {}", fmt::join(units_for(unit), ", "))));
  }
  range.from = *lower;
  range.to = *upper;
  if (unit != "1") range.unit = {name.empty() ? unit : name, 1};
  if (!name.empty()) range.unit.size = *quantity("1 " + name, unit);
  return range;
}

}  // namespace ricochet::cli
