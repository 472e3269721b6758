#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/scene.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline scene {
namespace {

std::string_view range_text(Range range) {
  switch (range) {
    case Range::positive:
      return "> 0";
    case Range::not_negative:
    case Range::frequency:
      return ">= 0";
    case Range::fraction:
      return "0..1";
    case Range::any:
    case Range::finite:
    case Range::by_rule:
      return "";
  }
  return "";
}

/// Writes the fields of a table, one line each.
struct FieldWriter {
  std::string& text;

  /// Unit, allowed range and meaning.
  static std::string comment(const Field& field) {
    std::string text = field.unit == "1" ? "" : std::string(field.unit);
    const auto append = [&text](std::string_view separator, std::string_view part) {
      if (!part.empty()) text += fmt::format("{}{}", text.empty() ? "" : separator, part);
    };
    append(" ", range_text(field.range));
    append(": ", field.remark);
    return text;
  }
  void line(const Field& field, std::string_view value, std::string_view comment) const {
    text += fmt::format("{} = {}{}{}\n", field.key, value, comment.empty() ? "" : "  # ", comment);
  }

  void operator()(const Field& field, double x) const {
    line(field, toml_float(x), comment(field));
  }
  void operator()(const Field& field, Walls<const double> x) const {
    if (x.lower == x.upper) return (*this)(field, x.lower);
    for (const auto& [wall, number] : {std::pair("lower", x.lower), std::pair("upper", x.upper)}) {
      const std::string key = fmt::format("{}_{}", field.key, wall);
      Field one = field;
      one.key = key;
      (*this)(one, number);
    }
  }
  void operator()(const Field& field,
                  PlateSpeed<const double, const std::vector<SpeedKnot<double>>> speed) const {
    if (speed.profile.empty()) return (*this)(field, speed.omega);
    std::vector<std::string> knots;
    for (const auto& knot : speed.profile) {
      knots.push_back(fmt::format("[{}, {}]", toml_float(knot.time), toml_float(knot.omega)));
    }
    line(field, fmt::format("[{}]", fmt::join(knots, ", ")), "s, " + comment(field));
  }
  void operator()(const Field& field, const std::optional<double>& x) const {
    if (x) return (*this)(field, *x);
    line(field, fmt::format("\"{}\"", open_number), "");
  }
  void operator()(const Field& field, bool x) const {
    line(field, x ? "true" : "false", comment(field));
  }
  template <class Enum>
  void operator()(const Field& field, Enum x) const {
    line(field, fmt::format("\"{}\"", name_of(names_of(x), x)), comment(field));
  }
};

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string text = "[scene]\n";
  const FieldWriter write{text};
  visit_scene_fields(write, scene);
  if (scene.across) {
    text += "\n[across]  # the second direction, y\n";
    visit_across_fields(write, *scene.across);
  }
  text += "\n[window]  # revolutions or seconds\n";
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    text += fmt::format("revolutions = {}\n", toml_float(turns->count));
  } else {
    text += fmt::format("seconds = {}\n", toml_float(std::get<Seconds>(scene.window).count));
  }
  text += "\n[count]\n";
  visit_count_fields(write, scene);
  text += "\n[model]\n";
  visit_model_fields(write, scene);
  return text;
}

}  // namespace ricochet::carrier_track::inline scene
