#include "src/research/surrogate/bias.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/machine.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/rank_correlation.h"
#include "src/core/progress.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;
using report::Json;

std::vector<double> over_speeds(const Machine& machine, double smoothing, const BiasPlan& plan) {
  std::vector<double> values(static_cast<std::size_t>(std::lround(fastest_speed / plan.step)));
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
    values[k] =
        objective(at_speed(machine.scene, static_cast<double>(k + 1) * plan.step), smoothing);
  });
  return values;
}

/// The last place at which the values are at most `level`.
std::optional<std::size_t> last_quiet(const std::vector<double>& values, double level) {
  for (std::size_t k = values.size(); k-- > 0;) {
    if (values[k] <= level) return k;
  }
  return std::nullopt;
}

Bias bias_at(double smoothing, const std::vector<double>& counts,
             const std::vector<double>& surrogate, const Machine& machine, const BiasPlan& plan) {
  Bias bias{smoothing, 0, rank_correlation(counts, surrogate), 0, {}, {}};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    bias.error += std::abs(surrogate[k] - counts[k]) / static_cast<double>(counts.size());
  }
  const auto lowest = std::min_element(surrogate.begin(), surrogate.end()) - surrogate.begin();
  bias.count_optimality_gap =
      counts[static_cast<std::size_t>(lowest)] - *std::min_element(counts.begin(), counts.end());
  const auto best = last_quiet(counts, machine.quiet_limit);
  const auto found = last_quiet(surrogate, half_level(machine.quiet_limit));
  if (!best || !found) return bias;
  const auto speed = [&](std::size_t k) { return static_cast<double>(k + 1) * plan.step; };
  bias.speed = speed(*found);
  bias.speed_optimality_gap = speed(*best) - speed(*found);
  bias.loud = counts[*found] > machine.quiet_limit;
  return bias;
}

}  // namespace

BiasStudy study_bias(const BiasPlan& plan) {
  BiasStudy study{plan, {}};
  const std::vector<Machine> machines = all_machines();
  Progress progress("surrogate gap", static_cast<double>(machines.size()));
  for (const Machine& machine : machines) {
    const std::vector<double> counts = over_speeds(machine, 0.0, plan);
    CaseBias& row = study.cases.emplace_back();
    row.id = machine.id;
    row.lowest = static_cast<int>(*std::min_element(counts.begin(), counts.end()));
    const auto best = last_quiet(counts, machine.quiet_limit);
    if (best) row.fastest = static_cast<double>(*best + 1) * plan.step;
    for (const double smoothing : plan.smoothings) {
      row.biases.push_back(
          bias_at(smoothing, counts, over_speeds(machine, smoothing, plan), machine, plan));
    }
    progress.advance(1);
  }
  return study;
}

namespace {

Json smoothing_data(const Bias& bias) {
  return {{"smoothing", bias.smoothing},
          {"error", bias.error},
          {"rank_correlation", bias.rank_correlation},
          {"count_optimality_gap", bias.count_optimality_gap},
          {"count_is_lowest", bias.count_optimality_gap <= 0},
          {"speed", bias.speed},
          {"speed_optimality_gap", bias.speed_optimality_gap},
          {"quiet", bias.speed ? Json(!bias.loud) : Json()}};
}

Json case_data(const CaseBias& row) {
  return {{"id", row.id},
          {"lowest", row.lowest},
          {"fastest", row.fastest},
          {"smoothings", report::list_of(row.biases, smoothing_data)}};
}

/// Error of the fastest quiet speed over the cases, at one smoothing parameter.
Json over_cases(const BiasStudy& study, std::size_t smoothing) {
  std::vector<double> wrong;
  int loud = 0;
  for (const CaseBias& row : study.cases) {
    const Bias& bias = row.biases[smoothing];
    wrong.push_back(bias.speed_optimality_gap ? std::abs(*bias.speed_optimality_gap) : 18.0);
    loud += bias.loud ? 1 : 0;
  }
  return {{"smoothing", study.plan.smoothings[smoothing]},
          {"median", quantile(wrong, 0.5)},
          {"worst", *std::max_element(wrong.begin(), wrong.end())},
          {"loud", loud},
          {"cases", study.cases.size()}};
}

}  // namespace

Json data_of(const BiasStudy& study) {
  const std::size_t last = study.plan.smoothings.size() - 1;
  std::size_t usual = 0;
  while (usual < last && study.plan.smoothings[usual] > 0.25) ++usual;
  return {{"usual", over_cases(study, usual)},
          {"narrowest", over_cases(study, last)},
          {"speeds", std::lround(18 / study.plan.step)},
          {"smoothings", study.plan.smoothings.size()},
          {"cases", report::list_of(study.cases, case_data)}};
}

}  // namespace ricochet::studies::surrogate
