#include "problems/carrier_track/advice/staircase_chart.h"

#include <algorithm>
#include <utility>

#include "ricochet/recording.h"
#include "ricochet/threshold.h"

namespace ricochet::studies::advice {

using namespace carrier_track;

std::vector<report::Sample> staircase_samples(const QuietSpeed& answer) {
  std::vector<report::Sample> samples;
  if (answer.is_of_the_long_run()) {
    for (const Regime& regime : answer.regimes) {
      samples.push_back({regime.from, regime.collisions_per_turn});
    }
    samples.push_back({answer.regimes.back().to, answer.regimes.back().collisions_per_turn});
    return samples;
  }
  const LogarithmicScan& scan = answer.scan;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size() || scan.omega(k + 1) > answer.options.fastest;
    if (k == 0 || last || scan.counts[k] != scan.counts[k - 1]) {
      samples.push_back({scan.omega(k), scan.counts[k]});
    }
    if (last) break;
  }
  return samples;
}

report::Chart staircase_chart(const QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked) {
  report::Chart chart;
  chart.name = "staircase";
  chart.title = std::move(title);
  chart.width = 960;
  chart.height = 400;
  const double fastest = answer.options.fastest;
  chart.series = {{"collisions", report::Mark::steps, staircase_samples(answer)}};
  double most = 0;
  for (const report::Sample& sample : chart.series.front().samples) {
    most = std::max(most, *sample.value);
  }
  chart.x = {.label = "speed [rad/s]", .range = report::Range{0, fastest}};
  chart.y = {.label = answer.is_of_the_long_run() ? "collisions a turn, in the long run"
                                                  : "collisions in the window",
             .range = report::Range{0, 1 + 1.1 * most}};
  const auto mark = [&](const std::optional<double>& omega, const std::string& label) {
    if (omega && *omega <= fastest) {
      chart.lines.push_back({report::Direction::vertical, *omega, label});
    }
  };
  for (const auto& [omega, label] : marked) mark(omega, label);
  for (const Step& step : answer.staircase.steps) mark(step.omega, "step");
  return chart;
}

}  // namespace ricochet::studies::advice
