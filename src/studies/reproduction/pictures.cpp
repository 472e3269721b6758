#include <fmt/format.h>

#include <algorithm>
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
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Chart;
using report::Direction;
using report::Mark;

constexpr std::size_t samples_of_a_path = 600;
constexpr double of_a_pixel = 1.0 / 4000;  // of the plot's width and height: a tenth, or less

/// Rounds to the digits that are visible in a picture.
double short_number(double value) {
  return std::round(value * 1e5) / 1e5;
}

std::vector<report::Sample> shortened(std::vector<report::Sample> samples) {
  for (report::Sample& sample : samples) {
    sample.position = short_number(sample.position);
    sample.value = short_number(*sample.value);
  }
  return samples;
}

/// The count over the speeds, with a sample only where it jumps.
Chart count_chart(const CaseStudy& c) {
  const SpeedScan scan = c.scan.step < 0.01 ? thinned(c.scan, 10) : c.scan;
  report::Series staircase{"", Mark::steps, {}};
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size();
    if (k > 0 && !last && scan.counts[k] == scan.counts[k - 1]) continue;
    staircase.samples.push_back({scan.omega(k), scan.counts[k]});
  }
  const double most = *std::ranges::max_element(scan.counts);
  const auto& claim = c.the_case.claim.threshold;
  const auto speed = [](const std::optional<double>& omega, const char* form) {
    return omega ? fmt::format(fmt::runtime(form), *omega) : std::string("none");
  };
  Chart chart{
      .name = "count",
      .title = fmt::format("{}: collisions in the window; threshold {} rad/s, the paper's {}",
                           c.the_case.id, speed(c.score.threshold, "{:.2f}"), speed(claim, "{}")),
      .x = {.label = "speed [rad/s]", .range = report::Range{0, 18}},
      .y = {.label = "collisions", .range = report::Range{0, 1.1 * most}},
      .series = {std::move(staircase)}};
  // In this order, so that each line looks the same in every chart.
  chart.lines = {{Direction::horizontal, quiet_limit(c.score.quiet_count), "quiet up to here"}};
  if (c.score.threshold)
    chart.lines.push_back({Direction::vertical, *c.score.threshold, "threshold"});
  if (claim) chart.lines.push_back({Direction::vertical, *claim, "paper's threshold"});
  return chart;
}

/// x(t) with the impacts that count, reduced to the corners that can be seen. Impacts of the start
/// are those in the first tenth of a turn.
Chart motion_chart(const CaseStudy& c, double omega, const std::string& where, std::string name,
                   const Recording& recording) {
  const Scene scene = at_speed(c.scene, omega);
  const double end_of_start = 0.1 * 2 * std::numbers::pi / omega;
  const auto start =
      std::ranges::count_if(counted_features(scene, recording),
                            [&](const Feature& impact) { return impact.time < end_of_start; });
  Chart chart = path_chart(scene, recording, std::move(name),
                           fmt::format("{} at {:.4g} rad/s, {}: {} impacts count, {} of the start",
                                       c.the_case.id, omega, where, recording.count, start));
  auto& path = chart.series.front();
  path.label = "";
  const double across = path.samples.back().position * of_a_pixel;
  const double up = (scene.wall_upper - scene.wall_lower) / millimetre * 4 * of_a_pixel;
  path.samples = shortened(report::simplified(path.samples, across, up));
  chart.series.back().samples = shortened(chart.series.back().samples);
  return chart;
}

report::Part part_of(const CaseStudy& c) {
  const Case& it = c.the_case;
  std::string id = it.id;
  id.front() = 'c';
  const std::string heading = fmt::format("{}: restitution {}, friction {}, disturbance {} N",
                                          it.id, it.restitution, it.friction, it.disturbance);
  report::Results own;
  own.set("heading", heading);
  own.add(count_chart(c));
  const auto add = [&](double omega, const std::string& where, const char* name) {
    const Recording recording =
        record(at_speed(c.scene, omega), default_smoothing, samples_of_a_path);
    own.set(name,
            recording.certainty.certain
                ? std::nullopt
                : std::optional("The count is not certain: " + recording.certainty.reason + "."));
    own.add(motion_chart(c, omega, where, name, recording));
  };
  if (const auto& figure = it.claim.figure) {
    add(figure->quiet, fmt::format("quiet in Figure {}", figure->number), "quiet");
    add(figure->loud, fmt::format("loud in Figure {}", figure->number), "loud");
  }
  // What changes at a threshold does not depend on the disturbance.
  if (c.score.threshold && it.disturbance == 0) {
    add(0.99 * *c.score.threshold, "just below its threshold", "below");
    add(1.01 * *c.score.threshold, "just above its threshold", "above");
  }
  return {id, heading, std::move(own)};
}

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

/// One of the two charts of Figure 3.
Chart crossing_chart(const char* name, const char* label, const char* title,
                     double TheoreticalMotion::*what) {
  report::Series motion{"", Mark::line, {}};
  double most = 0;
  for (double turned = -arc; turned <= 2 * half_crossing + arc; turned += 0.5) {
    const double value = motion_at(turned).*what;
    motion.samples.push_back({turned, value});
    most = std::max(most, value);
  }
  const double gain = most / (on_arc(radius, shown_speed).*what);
  return {.name = name,
          .title = fmt::format(fmt::runtime(title), gain),
          .x = {.label = "driver plates [degrees turned since the crossing began]"},
          .y = {.label = label, .range = report::Range{0, 1.1 * most}},
          .series = {std::move(motion)},
          .lines = {{Direction::vertical, 0, "crossing"},
                    {Direction::vertical, 2 * half_crossing, "crossing"}}};
}

}  // namespace

void add_pictures(const std::vector<CaseStudy>& cases, report::Results& results) {
  for (const CaseStudy& c : cases) results.add("cases", part_of(c));
  results.add(crossing_chart("crossing-speed", "speed [m/s]",
                             "At a crossing the carrier is up to {:.2g} times as fast as on an arc",
                             &TheoreticalMotion::speed));
  results.add(crossing_chart(
      "crossing-acceleration", "acceleration [m/s²]",
      "At a crossing the carrier accelerates up to {:.2g} times as much as on an arc",
      &TheoreticalMotion::acceleration));
}

namespace {

constexpr double least = 0.05, most = 0.95;  // restitution
constexpr int values = 121;

/// The map of the machine of `cases`, which differ in their restitution alone.
Chart map_of(const std::vector<const CaseStudy*>& cases) {
  advice::MapMarks marks;
  std::string quiet;
  for (const CaseStudy* c : cases) {
    const std::string& id = c->the_case.id;
    if (c->borders.quiet)
      quiet += fmt::format("{}{} is quiet up to {:.2f}", quiet.empty() ? "" : ", ", id,
                           *c->borders.quiet);
    if (const auto threshold = c->the_case.claim.threshold) {
      marks.thresholds.push_back(
          {c->the_case.restitution, *threshold, fmt::format("{}: {:.4g}", id, *threshold)});
    }
  }
  const double friction = cases.front()->the_case.friction;
  Chart chart = advice::regime_map_chart(
      regime_map(cases.front()->scene, {{"restitution", least, most}, values}),
      fmt::format("Friction {}, no disturbance: in the long run {} rad/s", friction, quiet), {},
      marks);
  chart.name = fmt::format("regimes-{}", friction);
  std::ranges::replace(chart.name, '.', '-');
  return chart;
}

}  // namespace

void add_maps(const std::vector<CaseStudy>& cases, report::Results& results) {
  std::map<double, std::vector<const CaseStudy*>> machines;  // by friction
  for (const CaseStudy& c : cases)
    if (c.the_case.disturbance == 0) machines[c.the_case.friction].push_back(&c);
  for (const auto& [friction, of_it] : machines) results.add(map_of(of_it));
}

}  // namespace ricochet::studies::reproduction
