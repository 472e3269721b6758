#include "src/studies/advice/study.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/scene/scene_doubts.h"
#include "src/studies/advice/quiet_speed_answer.h"

namespace ricochet::studies {
namespace {

using namespace carrier_track;
using namespace advice;
using report::Json;

constexpr double millimetre = 1e-3;  // [m]

/// The count over the speeds up to the fastest, with a row where it changes.
Json staircase_data(const QuietSpeed& answer) {
  Json rows = Json::array();
  const LogarithmicScan& scan = answer.scan;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size() || scan.omega(k + 1) > answer.options.fastest;
    if (k == 0 || last || scan.counts[k] != scan.counts[k - 1]) {
      rows.push_back({{"speed", scan.omega(k)}, {"count", scan.counts[k]}});
    }
    if (last) break;
  }
  return rows;
}

/// What the walls take, and the fastest impact, over the speeds.
Json wear_data(const Scene& scene, double fastest) {
  constexpr std::size_t speeds = 300;
  std::vector<Json> rows(speeds);
  tbb::parallel_for(std::size_t{0}, speeds, [&](std::size_t k) {
    const double omega = fastest * static_cast<double>(k + 1) / speeds;
    const Scene there = at_speed(scene, omega);
    rows[k] = {{"speed", omega},
               {"energy", 1e3 * measured(there, Measure::energy)},
               {"impact", measured(there, Measure::impact_speed)}};
  });
  return rows;
}

/// One run at a speed, with its impacts that count.
Json path_data(const Scene& scene, double omega, const char* side, const char* speed) {
  const Scene there = at_speed(scene, omega);
  const Recording recording = record(there, 0, 2000);
  const bool in_turns = std::holds_alternative<Revolutions>(there.window);
  const double unit = in_turns ? 2 * std::numbers::pi / omega : 1;
  Json path = Json::array();
  double last = -1;
  for (const Sample& s : recording.path) {
    if (s.time <= last) continue;  // an impact has two samples, before and after
    last = s.time;
    path.push_back({{"at", s.time / unit}, {"x", s.position / millimetre}});
  }
  Json impacts = Json::array();
  for (const Impact& impact : recording.impacts) {
    if (impact.speed <= there.slowest) continue;
    const double wall = impact.wall == Wall::upper ? there.wall_upper : there.wall_lower;
    impacts.push_back({{"at", impact.time / unit}, {"x", wall / millimetre}});
  }
  Json zoom;
  if (const auto stretch = busiest_stretch(there, recording)) {
    zoom = {{"from", stretch->from / unit}, {"to", stretch->to / unit}};
  }
  return {{"side", side},
          {"speed", speed},
          {"omega", omega},
          {"count", recording.count},
          {"unit", in_turns ? "driver plate [turns]" : "time [s]"},
          {"lower_wall", there.wall_lower / millimetre},
          {"upper_wall",
           std::isfinite(there.wall_upper) ? Json(there.wall_upper / millimetre) : Json()},
          {"zoom", std::move(zoom)},
          {"path", std::move(path)},
          {"impacts", std::move(impacts)}};
}

/// What each constant would have to change by for a tenth more speed.
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
  const QuietSpeedAnswer answer =
      answer_quiet_speed(options.name, options.scene, options.quiet_speed, options.tolerance);
  const QuietSpeed& found = answer.answer;
  Json data = json_of(answer);
  data["name"] = options.name;
  data["text"] = text_of(answer);
  data["headline"] = headline_of(answer);
  data["divide"] = found.split.speed;
  data["fastest"] = found.options.fastest;
  data["doubts"] = doubts_about(options.scene);
  data["staircase"] = staircase_data(found);
  int most = 0;
  for (const Json& row : data["staircase"]) most = std::max(most, row["count"].get<int>());
  data["most"] = 1 + 1.1 * most;
  data["wear"] = wear_data(options.scene, found.options.fastest);
  data["changes"] = change_data(answer.sensitivities);
  data["paths"] = Json::array();
  if (found.fastest_quiet) {
    data["paths"].push_back(
        path_data(options.scene, *found.fastest_quiet, "quiet", "fastest quiet speed"));
  }
  if (found.split.first_loud) {
    data["paths"].push_back(
        path_data(options.scene, *found.split.first_loud, "loud", "first speed that is louder"));
  }
  return data;
}

}  // namespace

Study advice_study(const AdviceOptions& options) {
  return {"advice", "", [options](bool /*quick*/) { return compute(options); }};
}

}  // namespace ricochet::studies
