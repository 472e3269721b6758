#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "ricochet/machine.h"
#include "src/report/painted.h"
#include "src/studies/machine/charts.h"
#include "src/studies/paper/theory.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Json;

constexpr double of_a_pixel = 1.0 / 4000;  // of the plot's width and height: a tenth, or less

/// Rounds to the digits that are visible in a picture.
double short_number(double value) {
  return std::round(value * 1e5) / 1e5;
}

/// The corners that suffice to draw x(t).
Json line_of(const Scene& scene, const Recording& recording) {
  const std::vector<report::Sample> samples = path_samples(scene, recording);
  const double across = samples.back().position * of_a_pixel;
  const double up = (scene.wall_upper - scene.wall_lower) / millimetre * 4 * of_a_pixel;
  return report::list_of(report::simplified(samples, across, up), [](const report::Sample& s) {
    return Json{{"at", short_number(s.position)}, {"x", short_number(*s.value)}};
  });
}

/// The impacts that count, as points of x(t).
Json marks_of(const Scene& scene, const Recording& recording) {
  return report::list_of(counted_samples(scene, recording), [](const report::Sample& s) {
    return Json{{"at", short_number(s.position)}, {"x", short_number(*s.value)}};
  });
}

/// The common parts of all charts of a case's paths.
Json frame_of(const CaseStudy& c, double omega) {
  const double lower = c.scene.wall_lower / millimetre;
  const double upper = c.scene.wall_upper / millimetre;
  const double margin = 0.1 * (upper - lower);
  return {{"id", c.the_case.id},
          {"restitution", c.the_case.restitution},
          {"friction", c.the_case.friction},
          {"omega", omega},
          {"lower_wall", lower},
          {"upper_wall", upper},
          {"bottom", lower - margin},
          {"top", upper + margin}};
}

Json path_of(const CaseStudy& c, double omega, const char* side, const Recording& recording) {
  Scene scene = c.scene;
  scene.omega = omega;
  Json path = frame_of(c, omega);
  path["figure"] = c.the_case.claim.figure->number;
  path["side"] = side;
  path["count"] = recording.count;
  path["doubt"] = recording.certainty.certain ? "" : recording.certainty.reason;
  path["path"] = line_of(scene, recording);
  path["marks"] = marks_of(scene, recording);
  return path;
}

/// Counted impacts, before and after the first tenth of a turn.
Json impacts_of(const CaseStudy& c, double omega, const Recording& recording) {
  const double end_of_start = 0.1 * 2 * std::numbers::pi / omega;
  int start = 0;
  int later = 0;
  for (const auto& impact : counted_features(c.scene, recording)) {
    ++(impact.time < end_of_start ? start : later);
  }
  return {{"omega", omega}, {"start", start}, {"later", later}};
}

/// The paths at one speed of all cases that differ from this one only in their disturbance.
Json overlaid(const std::vector<CaseStudy>& cases, const CaseStudy& c, double omega) {
  Json overlay = frame_of(c, omega);
  Json lines = Json::array();
  for (const CaseStudy& other : cases) {
    if (other.the_case.restitution != c.the_case.restitution) continue;
    if (other.the_case.friction != c.the_case.friction) continue;
    const Scene scene = at_speed(other.scene, omega);
    const Recording recording = record(scene, 0, samples_of_a_path);
    lines.push_back({{"id", other.the_case.id},
                     {"disturbance", other.the_case.disturbance},
                     {"count", recording.count},
                     {"path", line_of(scene, recording)},
                     {"marks", marks_of(scene, recording)}});
  }
  overlay["lines"] = std::move(lines);
  return overlay;
}

/// From below a case's threshold to the paper's loud speed.
Json frames_of(const std::vector<CaseStudy>& cases, const CaseStudy& c) {
  struct Place {
    double share;
    const char* text;
  };
  constexpr std::array<Place, 4> places{{{0.9, "a tenth below the threshold"},
                                         {0.99, "just below the threshold"},
                                         {1.01, "just above the threshold"},
                                         {1.1, "a tenth above the threshold"}}};
  Json frames = Json::array();
  const auto add = [&](double omega, const char* text) {
    Json frame = overlaid(cases, c, omega);
    frame["number"] = frames.size() + 1;
    frame["where"] = text;
    frames.push_back(std::move(frame));
  };
  if (c.score.threshold) {
    for (const Place& place : places) add(place.share * *c.score.threshold, place.text);
  }
  add(c.the_case.claim.figure->loud, "shown as loud");
  return frames;
}

}  // namespace

Json path_data(const std::vector<CaseStudy>& cases) {
  Json impacts = Json::array();
  Json paths = Json::array();
  Json quiet = Json::array();
  Json frames = Json::array();
  for (const CaseStudy& c : cases) {
    if (!c.paths) continue;
    const auto& figure = *c.the_case.claim.figure;
    const auto& id = c.the_case.id;
    if (c.the_case.disturbance != 0) {
      paths.push_back(path_of(c, figure.quiet, "quiet", c.paths->quiet));
      paths.push_back(path_of(c, figure.loud, "loud", c.paths->loud));
      continue;
    }
    quiet.push_back(overlaid(cases, c, figure.quiet));
    for (Json& frame : frames_of(cases, c)) frames.push_back(std::move(frame));
    if (id == "C3") continue;
    impacts.push_back({{"id", id},
                       {"restitution", c.the_case.restitution},
                       {"friction", c.the_case.friction},
                       {"quiet", impacts_of(c, figure.quiet, c.paths->quiet)},
                       {"loud", impacts_of(c, figure.loud, c.paths->loud)}});
  }
  return {{"impacts", std::move(impacts)},
          {"quiet", std::move(quiet)},
          {"frames", std::move(frames)},
          {"paths", std::move(paths)}};
}

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double radius = 0.065;      // [m], the paper's radius of the spindle's path
constexpr double shown_speed = 9.0;   // [rad/s], the paper's threshold of case C1
constexpr double half_crossing = 45;  // [degrees]; not in the paper
constexpr double arc = 60;            // [degrees] shown on either side

/// `turned` [degrees] from where the crossing begins.
TheoreticalMotion motion_at(double turned) {
  if (turned < 0 || turned > 2 * half_crossing) return on_arc(radius, shown_speed);
  const double angle = turned <= half_crossing ? turned : turned - 2 * half_crossing;
  return on_crossing(radius, shown_speed, angle * degree);
}

}  // namespace

report::Json crossing_data() {
  report::Json motion = report::Json::array();
  TheoreticalMotion most{};
  for (double turned = -arc; turned <= 2 * half_crossing + arc; turned += 0.5) {
    const TheoreticalMotion at = motion_at(turned);
    motion.push_back({{"turned", turned}, {"speed", at.speed}, {"acceleration", at.acceleration}});
    most.speed = std::max(most.speed, at.speed);
    most.acceleration = std::max(most.acceleration, at.acceleration);
  }
  return {{"end", 2 * half_crossing},
          {"speed_gain", most.speed / on_arc(radius, shown_speed).speed},
          {"acceleration_gain", most.acceleration / on_arc(radius, shown_speed).acceleration},
          {"top_speed", 1.1 * most.speed},
          {"top_acceleration", 1.1 * most.acceleration},
          {"motion", std::move(motion)}};
}

namespace {

using advice::MapMarks;

constexpr double least = 0.05, most = 0.95;  // restitution
constexpr int values = 31;

Json areas_of(const report::Chart& chart) {
  return report::list_of(chart.areas, [](const report::Area& area) {
    return Json{{"label", area.label},
                {"name", area.name},
                {"shade", report::as_json(area.shade)},
                {"parts", report::list_of(area.parts, [](const auto& part) {
                   return report::list_of(part, [](const report::Area::Edge& edge) {
                     return Json::array({edge.position, edge.between.lower, edge.between.upper});
                   });
                 })}};
  });
}

Json series_of(const report::Chart& chart) {
  return report::list_of(chart.series, [](const report::Series& series) {
    return Json{{"label", series.label},
                {"mark", series.mark == report::Mark::points ? "points" : "line"},
                {"samples", report::list_of(series.samples, [](const report::Sample& sample) {
                   return Json{{"x", sample.position},
                               {"y", report::as_json(sample.value)},
                               {"name", sample.name}};
                 })}};
  });
}

/// The map of the machine of `cases`, which differ in their restitution alone.
RestitutionMap map_of(const std::vector<const CaseStudy*>& cases) {
  MapMarks marks;
  std::vector<QuietCase> quiet;
  for (const CaseStudy* c : cases) {
    const std::string& id = c->the_case.id;
    quiet.push_back({id, c->borders.quiet});
    if (const auto threshold = c->the_case.claim.threshold) {
      marks.thresholds.push_back(
          {c->the_case.restitution, *threshold, fmt::format("{}: {:.4g}", id, *threshold)});
    }
  }
  return {cases.front()->the_case.friction, std::move(quiet),
          regime_map(cases.front()->scene, {"restitution", least, most, values}), marks};
}

Json json_of(const RestitutionMap& shown) {
  const report::Chart chart = advice::regime_map_chart(shown.map, "", {}, shown.marks);
  return {{"friction", shown.friction},
          {"cases", report::as_json(shown.cases)},
          {"least", least},
          {"most", most},
          {"fastest", shown.map.options.speeds.to},
          {"areas", areas_of(chart)},
          {"series", series_of(chart)}};
}

}  // namespace

std::vector<RestitutionMap> restitution_maps(const std::vector<CaseStudy>& cases) {
  std::map<double, std::vector<const CaseStudy*>> machines;  // by friction
  for (const CaseStudy& c : cases) {
    if (c.the_case.disturbance == 0) machines[c.the_case.friction].push_back(&c);
  }
  std::vector<RestitutionMap> maps;
  for (const auto& [friction, of_it] : machines) maps.push_back(map_of(of_it));
  return maps;
}

Json regime_map_data(const std::vector<RestitutionMap>& maps) {
  if (maps.empty()) return {};
  return {{"maps", report::list_of(maps, json_of)}};
}

}  // namespace ricochet::studies::reproduction
