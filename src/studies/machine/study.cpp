#include "src/studies/machine/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "src/report/results.h"
#include "src/studies/machine/answer.h"
#include "src/studies/machine/charts.h"
#include "src/studies/machine/design_parameters.h"
#include "src/studies/machine/regime_tables.h"

namespace ricochet::studies {

namespace {

using namespace carrier_track;
using namespace advice;
using report::Results;

/// The change of each constant that would give a tenth more speed.
Table change_table(const std::vector<Sensitivity>& all) {
  Table table{"changes",
              {{"constant"},
               {"percent", "one per cent more moves the speed by [%]", "+.2f"},
               {"for_a_tenth", "for a tenth more speed, change it by [%]", "+.1%"}}};
  for (const Sensitivity& s : all) {
    if (std::abs(s.percent) < 0.05) continue;  // would have to change more than twofold
    table.add(s.key, s.percent, std::expm1(std::log(1.1) / s.percent));
  }
  return table;
}

/// A row for each line.
Table lines_table(std::string name, const std::vector<std::string>& lines) {
  Table table{std::move(name), {{"line"}}};
  for (const std::string& line : lines) table.add(line);
  return table;
}

/// What a speed costs.
struct Wear {
  double omega;   ///< [rad/s]
  double energy;  ///< [J] that the walls take, in a turn or in the window
  double impact;  ///< [m/s], the fastest
};

/// At both ends of all regimes.
std::vector<Wear> wear_of(const std::vector<Regime>& regimes) {
  std::vector<Wear> all;
  for (const Regime& regime : regimes) {
    for (const LongRun& run : {regime.first, regime.last}) {
      all.push_back({run.orbit.omega, run.energy_per_turn, run.fastest_impact});
    }
  }
  return all;
}

/// The same in the window, over the speeds.
std::vector<Wear> wear_of(const Scene& scene, double fastest) {
  constexpr std::size_t count = 300;
  std::vector<double> speeds;
  for (std::size_t k = 1; k <= count; ++k)
    speeds.push_back(fastest * static_cast<double>(k) / count);
  const auto energies = measured_at(scene, Measure::energy, speeds);
  const auto impacts = measured_at(scene, Measure::impact_speed, speeds);
  std::vector<Wear> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back({speeds[k], energies[k], impacts[k]});
  return all;
}

void add_wear(const std::vector<Wear>& all, const QuietSpeed& found, Results& results) {
  report::Chart energy{.name = "energy",
                       .title = found.is_of_the_long_run()
                                    ? "Energy that the walls take in a turn"
                                    : "Energy that the walls take in the window",
                       .x = {"speed [rad/s]", {}, report::Range{0, found.options.fastest}},
                       .y = {"energy [mJ]"},
                       .series = {{"energy", report::Mark::line, {}}}};
  if (found.fastest_quiet) {
    energy.lines = {{report::Direction::vertical, *found.fastest_quiet, "fastest quiet speed"}};
  }
  report::Chart impact = energy;
  impact.name = "impact";
  impact.title = "Approach speed of the fastest impact";
  impact.y.label = "approach speed [m/s]";
  impact.series.front().label = "fastest impact";
  for (const Wear& one : all) {
    energy.series.front().samples.push_back({one.omega, 1e3 * one.energy});
    impact.series.front().samples.push_back({one.omega, one.impact});
  }
  results.add(std::move(energy));
  results.add(std::move(impact));
}

/// The machine that starts on its motion in the long run at that speed, with a window of two turns;
/// the scene itself for a limit of the window.
Scene in_the_long_run(const Scene& scene, const QuietSpeed& found, double omega) {
  for (const Regime& regime : found.regimes) {
    if (omega > regime.to) continue;
    Scene orbit = omega < regime.to ? regime.last.orbit : regime.first.orbit;
    orbit.window = Revolutions{2};
    return orbit;
  }
  return scene;
}

/// One run at a speed, with its counted events, as a part of the page. Throws TimeLimitReached.
void add_path(const Scene& scene, const QuietSpeed& found, double omega, const char* id,
              const char* speed, Results& results) {
  const Scene there = at_speed(in_the_long_run(scene, found, omega), omega);
  const Recording recording = record(there, 0, 2000);
  if (!recording.complete) throw TimeLimitReached();
  Results own;
  own.set("what-counts", counted_label(there));
  own.set("count", recording.count);
  report::Chart path =
      path_chart(there, recording, "path",
                 fmt::format("{} collisions at {:.3f} rad/s", recording.count, omega));
  path.width = 900;
  own.add(std::move(path));
  if (auto zoom = zoom_chart(there, recording)) {
    zoom->width = 900;
    own.add(std::move(*zoom));
  }
  results.add("paths", {id, fmt::format("{:.3f} rad/s, the {}", omega, speed), std::move(own)});
}

std::optional<std::string> if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

Results results_of(const AdviceOptions& options) {
  QuietSpeedAnswer answer = answer_quiet_speed(options.name, options.scene, options.quiet_speed,
                                               options.tolerance, options.source);
  const QuietSpeed& found = answer.answer;
  Results results;
  const auto in_time = [&](const char* part, const auto& add) {
    try {
      add();
    } catch (const TimeLimitReached&) {
      answer.left_out.emplace_back(part);
    }
  };
  std::vector<Wear> wear = wear_of(found.regimes);
  if (!found.is_of_the_long_run())
    in_time("wear", [&] { wear = wear_of(options.scene, found.options.fastest); });
  std::vector<DesignLine> lines;
  in_time("variants of the machine", [&] { lines = design_lines(options.scene, found); });
  std::optional<std::string> model;
  in_time("planar model", [&] {
    model = planar_sentence(options.scene, found.fastest_quiet.value_or(found.options.fastest));
  });
  in_time("paths", [&] {
    if (found.fastest_quiet) {
      add_path(options.scene, found, *found.fastest_quiet, "quiet", "fastest quiet speed", results);
    }
    if (found.split.first_loud) {
      add_path(options.scene, found, *found.split.first_loud, "loud", "first speed that is louder",
               results);
    }
  });
  results.set("name", options.name);
  results.set("answer", headline_of(answer));
  results.set("missing", answer.is_complete() ? std::nullopt : if_any(known_part_of(answer)));
  results.set("tolerance", tolerance_sentence(answer));
  results.set("uncertainties", uncertainty_sentence(answer));
  results.set("strongest", strongest_of(answer));
  results.set("planar", model);
  results.set("fastest-quiet", found.fastest_quiet);
  results.set("divide", answer.sensitivities.empty() ? std::nullopt : found.split.speed);
  results.set("irregular", !found.reached && is_irregular(options.scene, found)
                               ? std::optional("At some speeds the motion does not repeat: a "
                                               "variant would take seconds, so none is computed.")
                               : std::nullopt);
  results.set("long-run",
              found.is_of_the_long_run() ? std::optional(summary_of(found.regimes)) : std::nullopt);
  const std::optional<Step> main_step = found.staircase.main_step();
  results.set("main-step", main_step ? std::optional(main_step->omega) : std::nullopt);
  results.add(lines_table("doubts", doubts_about(options.scene)));
  results.add(lines_table("notes", notes_on(options.scene, answer.start)));
  results.add(change_table(answer.sensitivities));
  add_design(lines, found, coarse_scan(options.scene, found), results);
  results.add(shown_regimes(found.regimes));
  results.add(step_table(found.staircase.steps));
  results.add(level_table(found.staircase.levels));
  results.add(around_table(found.around));
  results.add(staircase_chart(found,
                              found.is_of_the_long_run() ? "Collisions a turn, in the long run"
                                                         : "Collisions in the window",
                              {{found.fastest_quiet, "fastest quiet speed"}}));
  if (!wear.empty()) add_wear(wear, found, results);
  std::string text = text_of(answer);
  text.pop_back();  // its last line's end
  results.set("text", text);
  return results;
}

}  // namespace

Study advice_study(const AdviceOptions& options) {
  return {"advice", "", [options](bool /*quick*/) { return json_of(results_of(options)); }};
}

}  // namespace ricochet::studies
