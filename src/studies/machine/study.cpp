#include "src/studies/machine/study.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "src/core/in_parallel.h"
#include "src/studies/machine/answer.h"
#include "src/studies/machine/charts.h"
#include "src/studies/machine/design_parameters.h"
#include "src/studies/machine/regime_tables.h"

namespace ricochet::studies {

namespace {

using namespace carrier_track;
using namespace advice;
using report::Json;

/// The table of the regimes, in an engineer's units.
Json regime_rows(const std::vector<Regime>& regimes) {
  return report::list_of(without_narrow(regimes), [](const Regime& regime) {
    return Json{{"from", regime.from},
                {"to", regime.to},
                {"rpm", regime.to * rpm},
                {"collisions", counts_of(regime)},
                {"energy", 1e3 * regime.last.energy_per_turn},
                {"impact", 1e3 * regime.last.fastest_impact},
                {"rest", regime.last.share_at_rest},
                {"ends_by", name_of(regime.ends_by)}};
  });
}

/// The energy taken by the walls in a turn and the fastest impact, at both ends of all regimes.
Json wear_data(const std::vector<Regime>& regimes) {
  Json rows = Json::array();
  for (const Regime& regime : regimes) {
    for (const LongRun& run : {regime.first, regime.last}) {
      rows.push_back({{"speed", run.orbit.omega},
                      {"energy", 1e3 * run.energy_per_turn},
                      {"impact", run.fastest_impact}});
    }
  }
  return rows;
}

/// The same in the window, over the speeds.
Json wear_data(const Scene& scene, double fastest) {
  constexpr std::size_t speeds = 300;
  std::vector<Json> rows(speeds);
  in_parallel("wear", speeds, [&](std::size_t k) {
    const double omega = fastest * static_cast<double>(k + 1) / speeds;
    const Scene there = at_speed(scene, omega);
    rows[k] = {{"speed", omega},
               {"energy", 1e3 * measured(there, Measure::energy)},
               {"impact", measured(there, Measure::impact_speed)}};
  });
  return rows;
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

Json rows_of(const std::vector<report::Sample>& samples) {
  return report::list_of(samples, [](const report::Sample& sample) {
    return Json{{"at", sample.position}, {"x", sample.value}};
  });
}

/// One run at a speed, with its counted events.
Json path_data(const Scene& scene, double omega, const char* side, const char* speed) {
  const Scene there = at_speed(scene, omega);
  const Recording recording = record(there, 0, 2000);
  Json zoom;
  if (const auto part = path_zoom(there, recording)) {
    zoom = {{"from", part->at.lower}, {"to", part->at.upper},   {"bottom", part->x.lower},
            {"top", part->x.upper},   {"walls", Json::array()}, {"path", rows_of(part->path)}};
    for (const double wall : {there.wall_lower / millimetre, there.wall_upper / millimetre}) {
      if (wall >= part->x.lower && wall <= part->x.upper) zoom["walls"].push_back({{"x", wall}});
    }
  }
  return {{"side", side},
          {"speed", speed},
          {"omega", omega},
          {"count", recording.count},
          {"axis", path_axis(there).label},
          {"lower_wall", there.wall_lower / millimetre},
          {"upper_wall",
           std::isfinite(there.wall_upper) ? Json(there.wall_upper / millimetre) : Json()},
          {"zoom", std::move(zoom)},
          {"path", rows_of(path_samples(there, recording))},
          {"what_counts", counted_label(there)},
          {"counted", rows_of(counted_samples(there, recording))}};
}

/// The change of each constant that would give a tenth more speed.
Json change_data(const std::vector<Sensitivity>& all) {
  Json rows = Json::array();
  for (const Sensitivity& s : all) {
    if (std::abs(s.percent) < 0.05) continue;  // would have to change more than twofold
    rows.push_back({{"key", s.key},
                    {"percent", s.percent},
                    {"for_a_tenth", std::expm1(std::log(1.1) / s.percent)}});
  }
  return rows;
}

Json compute(const AdviceOptions& options) {
  QuietSpeedAnswer answer = answer_quiet_speed(options.name, options.scene, options.quiet_speed,
                                               options.tolerance, options.source);
  const auto in_time = [&](const char* part, const auto& part_of_page) -> Json {
    try {
      return part_of_page();
    } catch (const TimeLimitReached&) {
      answer.left_out.emplace_back(part);
      return {};
    }
  };
  const QuietSpeed& found = answer.answer;
  Json data;
  data["name"] = options.name;
  data["divide"] = found.split.speed;
  data["fastest"] = found.options.fastest;
  data["doubts"] = doubts_about(options.scene);
  double most = 0;
  data["staircase"] = Json::array();
  for (const report::Sample& sample : staircase_samples(found)) {
    data["staircase"].push_back({{"speed", sample.position}, {"count", sample.value}});
    most = std::max(most, *sample.value);
  }
  data["most"] = 1 + 1.1 * most;
  data["when"] = found.is_of_the_long_run() ? "a turn, in the long run" : "in the window";
  data["wear"] = found.is_of_the_long_run() ? wear_data(found.regimes) : in_time("wear", [&] {
    return wear_data(options.scene, found.options.fastest);
  });
  data["regime_rows"] = regime_rows(found.regimes);
  data["irregular"] = !found.reached && is_irregular(options.scene, found);
  data["changes"] = change_data(answer.sensitivities);
  data["explorer"] = in_time("variants of the machine",
                             [&] { return json_of(design_parameter_grid(options.scene, found)); });
  data["model"] = in_time("planar model", [&] { return model_choice(options.scene, found); });
  data["paths"] = Json::array();
  if (found.fastest_quiet) {
    data["paths"].push_back(path_data(in_the_long_run(options.scene, found, *found.fastest_quiet),
                                      *found.fastest_quiet, "quiet", "fastest quiet speed"));
  }
  if (found.split.first_loud) {
    const double loud = *found.split.first_loud;
    data["paths"].push_back(path_data(in_the_long_run(options.scene, found, loud), loud, "loud",
                                      "first speed that is louder"));
  }
  data.update(json_of(answer));
  data["text"] = text_of(answer);
  data["answer"] = headline_of(answer);
  data["missing"] = answer.is_complete() ? Json() : Json(known_part_of(answer));
  return data;
}

}  // namespace

Study advice_study(const AdviceOptions& options) {
  return {"advice", "", [options](bool /*quick*/) { return compute(options); }};
}

}  // namespace ricochet::studies
