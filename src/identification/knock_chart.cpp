#include "src/identification/knock_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::studies::identification {

using namespace carrier_track;

namespace {

constexpr double shown_deviations = 5;
constexpr int width = 960, height = 320;

std::vector<PredictedImpact> recordable(const KnockDensity& density) {
  std::vector<PredictedImpact> impacts;
  for (const PredictedImpact& impact : density.impacts()) {
    if (density.recorded_share(impact) > 0.05) impacts.push_back(impact);
  }
  return impacts;
}

/// How much later [s] than the nearest predicted impact a knock is; nothing without impacts.
std::optional<double> delay(const std::vector<PredictedImpact>& impacts, double time) {
  const auto after = std::ranges::lower_bound(impacts, time, {}, &PredictedImpact::time);
  std::optional<double> nearest;
  if (after != impacts.end()) nearest = time - after->time;
  if (after != impacts.begin()) {
    const double late = time - std::prev(after)->time;
    if (!nearest || late < -*nearest) nearest = late;
  }
  return nearest;
}

report::Chart residual_chart(const KnockLoss& loss, const std::vector<PredictedImpact>& impacts,
                             double jitter) {
  report::Chart chart;
  chart.name = "residuals";
  chart.title = "Recorded minus predicted times";
  chart.x.label = "time [s]";
  chart.y.label = "residual [ms]";
  const double limit = shown_deviations * jitter;
  chart.y.range = report::Range{-1.2e3 * limit, 1.2e3 * limit};
  report::Series near{"knock", report::Mark::points, {}};
  report::Series far{"knock that no impact explains, at the edge", report::Mark::points, {}, true};
  for (const Knock& knock : loss.record().knocks) {
    const std::optional<double> late = delay(impacts, knock.time);
    if (late && std::abs(*late) <= limit) {
      near.samples.push_back({knock.time, 1e3 * *late});
    } else {
      far.samples.push_back({knock.time, late && *late < 0 ? -1.1e3 * limit : 1.1e3 * limit});
    }
  }
  for (report::Series* series : {&near, &far}) {
    if (!series->samples.empty()) chart.series.push_back(std::move(*series));
  }
  chart.lines = {{report::Direction::horizontal, 1e3 * jitter, "jitter, as fitted"},
                 {report::Direction::horizontal, -1e3 * jitter, "jitter, as fitted"}};
  return chart;
}

report::Chart angle_chart(const KnockLoss& loss, const std::vector<PredictedImpact>& impacts,
                          const KnockUnknowns& at) {
  const KnockRecord& record = loss.record();
  const auto angles = [&](const auto& events) {
    std::vector<report::Sample> samples;
    double time = record.from;
    double turned = 0;
    for (const auto& event : events) {
      turned += angle_between(record.speed, time, event.time);
      time = event.time;
      const double alpha = at.phase + at.speed_factor * turned;
      const double turns = alpha / (2 * std::numbers::pi);
      samples.push_back({time, 360 * (turns - std::floor(turns))});
    }
    return samples;
  };
  report::Chart chart;
  chart.name = "angles";
  chart.title = "Where in the plate's turn the carrier knocks";
  chart.x.label = "time [s]";
  chart.y = {.label = "plate's angle [degrees]", .range = report::Range{0, 360}};
  chart.series = {{"predicted", report::Mark::points, angles(impacts), true},
                  {"recorded", report::Mark::points, angles(record.knocks)}};
  return chart;
}

}  // namespace

std::vector<report::Chart> knock_charts(const KnockLoss& loss, const Vector& x) {
  const std::vector<PredictedImpact> impacts = recordable(loss.density(x));
  const KnockUnknowns at = unknowns_at(x);
  std::vector<report::Chart> charts = {residual_chart(loss, impacts, at.jitter),
                                       angle_chart(loss, impacts, at)};
  for (report::Chart& chart : charts) {
    chart.x.range = report::Range{loss.record().from, loss.record().to};
    chart.width = width;
    chart.height = height;
  }
  return charts;
}

}  // namespace ricochet::studies::identification
