#include "src/cli/regime_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <string>

#include "problems/carrier_track/advice/regime_curve_table.h"
#include "problems/carrier_track/advice/regime_map_chart.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "src/cli/constant_range.h"
#include "src/cli/limited.h"
#include "src/cli/output_files.h"
#include "src/core/text_file.h"
#include "src/report/drawn_chart.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using namespace studies::advice;

/// "normal force" for normal_force.
std::string words_for(std::string constant) {
  std::ranges::replace(constant, '_', ' ');
  return constant;
}

/// Whether two machines are equal but for that constant.
bool differ_in_one(const std::string& constant, const Scene& a, Scene b) {
  if (constant == "restitution" && b.restitution_lower != b.restitution_upper) return false;
  set_constant(b, constant, constant_named(a, constant));
  return write_scene(a) == write_scene(b);
}

/// The machine, and the paper's thresholds of all cases that are on its map.
MapMarks marks_of(const ChosenScene& chosen, const RegimeMap& map, const ShownUnit& unit) {
  const std::string& constant = map.options.constant;
  MapMarks marks;
  const auto is_on_map = [&](double value) {
    return map.options.from <= value && value <= map.options.to;
  };
  if (is_on_map(map.own)) {
    marks.machines.push_back(
        {map.own, fmt::format("{}: {} {:.4g}{}{}", chosen.name, words_for(constant),
                              map.own / unit.size, unit.name.empty() ? "" : " ", unit.name)});
  }
  for (const ChosenScene& other : every_case()) {
    const double value = constant_named(other.scene, constant);
    if (!other.claim.threshold || !is_on_map(value)) continue;
    if (!differ_in_one(constant, chosen.scene, other.scene)) continue;
    marks.thresholds.push_back({value, *other.claim.threshold,
                                fmt::format("{}: {:.4g}", other.name, *other.claim.threshold)});
  }
  return marks;
}

report::Plot plot_of(const ChosenScene& chosen, const RegimeMap& map, const ShownUnit& unit) {
  const std::string title =
      fmt::format("Collisions a turn in the long run: {} with other values of the {}", chosen.name,
                  words_for(map.options.constant));
  return report::plot_of({regime_map_chart(map, title, unit, marks_of(chosen, map, unit))});
}

}  // namespace

int regime_curves(const RegimesOptions& options) {
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_file("--csv", options.csv, options.scene.scene_file, "the scene");
  refuse_same_file("--plot", options.plot, options.scene.scene_file, "the scene");
  refuse_same_file("--plot", options.plot, options.csv, "that of --csv");
  const ConstantRange range = constant_range_of(options.over);
  const RegimeMap map = limited(options.seconds, [&] {
    return regime_map(chosen.scene,
                      {range.constant, range.from, range.to, options.values, options.range});
  });
  std::deque<TextDraft> drafts;
  if (!options.csv.empty()) drafts.emplace_back(options.csv, csv_of(map));
  report::Plot plot;
  if (!options.plot.empty()) plot = plot_of(chosen, map, range.unit);
  if (!plot.svg.empty()) drafts.emplace_back(options.plot, plot.svg);
  for (TextDraft& draft : drafts) draft.commit();
  if (options.json) {
    report::Json json = {{"machine", chosen.name}};
    json.update(json_of(map));
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: borders between regimes over {}; the machine itself has {:.4g}{}{}.\n{}",
               chosen.name, range.constant, map.own / range.unit.size,
               range.unit.name.empty() ? "" : " ", range.unit.name, text_of(map, range.unit));
  }
  report::require_none(plot.failures);
  return 0;
}

}  // namespace ricochet::cli
