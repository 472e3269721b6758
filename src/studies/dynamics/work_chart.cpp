#include <algorithm>
#include <cmath>
#include <utility>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Scale;

/// Errors are drawn no smaller than this: the rounding of a time, or half an impact in the rate.
double smallest_error(const SceneWork& work) {
  return work.arena.chaotic ? 0.5 / work.impacts : 1e-16;
}

double cost_of(const SceneWork& work, const Trial& trial) {
  return trial.seconds / work.impacts;
}

/// From the decade below the smallest error to one above the largest: where failures are drawn.
report::Range errors_of(const SceneWork& work) {
  report::Range range{1e-3, 1e-3};
  for (const MethodWork& method : work.methods) {
    for (const Trial& trial : method.trials) {
      if (!trial.error || method.control == "none") continue;
      const double error = std::max(*trial.error, smallest_error(work));
      range = {std::min(range.lower, error), std::max(range.upper, error)};
    }
  }
  return {std::pow(10, std::floor(std::log10(range.lower))),
          std::pow(10, std::ceil(std::log10(range.upper)) + 1)};
}

}  // namespace

report::Figure work_chart(const SceneWork& work) {
  report::Chart chart;
  chart.name = "work-" + work.arena.id;
  chart.title = work.arena.name;
  chart.x = {"processor time per impact [s]", Scale::logarithmic};
  const report::Range errors = errors_of(work);
  chart.y = {work.arena.chaotic ? "relative error of impacts per second" : "impact-time error [s]",
             Scale::logarithmic, report::Range{errors.lower, 3 * errors.upper}};
  chart.lines = {{report::Direction::horizontal, errors.upper, "failed"}};
  for (const MethodWork& method : work.methods) {
    if (method.control == "none") {
      chart.lines.push_back(
          {report::Direction::vertical, cost_of(work, method.trials.front()), method.method});
      continue;
    }
    report::Series series{method.method, report::Mark::points, {}};
    for (const Trial& trial : method.trials) {
      const double error =
          trial.error ? std::max(*trial.error, smallest_error(work)) : errors.upper;
      series.samples.push_back({cost_of(work, trial), error});
    }
    chart.series.push_back(std::move(series));
  }
  if (work.arena.chaotic && work.rate_spread > errors.lower) {
    chart.lines.push_back(
        {report::Direction::horizontal, work.rate_spread, "as right as can be told"});
  }
  chart.width = 640;
  chart.height = 400;
  std::string caption = "Left is cheap, low is accurate.";
  if (work.arena.chaotic) caption += " Errors below half an impact are drawn as that.";
  return {std::move(chart), std::move(caption)};
}

}  // namespace ricochet::studies::dynamics
