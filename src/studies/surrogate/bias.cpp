#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;
using report::Chart;
using report::Scale;
using report::Series;

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

/// Sentences name this smoothing parameter, or the next smaller one of the plan.
constexpr double usual_smoothing = carrier_track::default_smoothing;

std::size_t usual_of(const BiasPlan& plan) {
  const std::size_t last = plan.smoothings.size() - 1;
  std::size_t usual = 0;
  while (usual < last && plan.smoothings[usual] > usual_smoothing) ++usual;
  return usual;
}

/// Error of the top speed in the window over the cases, at one smoothing parameter.
struct SpeedError {
  double median, worst;  ///< [rad/s]; of a surrogate that is never quiet, the whole range
  int loud = 0;          ///< cases
};

SpeedError speed_error(const BiasStudy& study, std::size_t smoothing) {
  std::vector<double> wrong;
  int loud = 0;
  for (const CaseBias& row : study.cases) {
    const Bias& bias = row.biases[smoothing];
    wrong.push_back(bias.speed_optimality_gap ? std::abs(*bias.speed_optimality_gap)
                                              : fastest_speed);
    loud += bias.loud ? 1 : 0;
  }
  return {quantile(wrong, 0.5), *std::max_element(wrong.begin(), wrong.end()), loud};
}

std::string finding_of(const BiasStudy& study) {
  const std::size_t usual = usual_of(study.plan), last = study.plan.smoothings.size() - 1;
  const SpeedError wide = speed_error(study, usual), narrow = speed_error(study, last);
  return fmt::format(
      "At smoothing parameter {:g} the fastest speed that the surrogate calls quiet is off by "
      "{:.2f} rad/s in the median of {} cases, by {:.2f} at worst, and truly loud in {}; at {:g} "
      "it is off by {:.2f} and {:.2f} rad/s, but still truly loud in {}.",
      study.plan.smoothings[usual], wide.median, study.cases.size(), wide.worst, wide.loud,
      study.plan.smoothings[last], narrow.median, narrow.worst, narrow.loud);
}

/// Whether the surrogate errs towards loud speeds.
std::string side_of(const BiasStudy& study) {
  int fast = 0, slow = 0, right = 0, never = 0;
  for (const CaseBias& row : study.cases) {
    for (const Bias& bias : row.biases) {
      never += !bias.speed;
      if (!bias.speed) continue;
      const double half_step = 0.5 * study.plan.step;
      fast += *bias.speed_optimality_gap < -half_step;
      slow += *bias.speed_optimality_gap > half_step;
      right += std::abs(*bias.speed_optimality_gap) <= half_step;
    }
  }
  const std::string unquiet =
      never > 0 ? fmt::format(" In {} it calls no speed quiet.", never) : std::string();
  return fmt::format(
      "In {} of {} pairs of a case and a smoothing parameter the surrogate's top speed in the "
      "window "
      "is "
      "too high, in {} too low and in {} right to {:g} rad/s.{}",
      fast, fast + slow + right + never, slow, right, study.plan.step, unquiet);
}

std::string at_minimum(const BiasStudy& study) {
  std::size_t all = 0, higher = 0;
  double most = 0;
  for (const CaseBias& row : study.cases) {
    for (const Bias& bias : row.biases) {
      ++all;
      higher += bias.count_optimality_gap > 0;
      most = std::max(most, bias.count_optimality_gap);
    }
  }
  const std::string where = "The count where the surrogate has its minimum is ";
  if (higher == 0) {
    return where + "the lowest of all speeds, in every case and at every smoothing parameter.";
  }
  return where + fmt::format(
                     "above the lowest of all speeds in {} of {} pairs of a case and a smoothing "
                     "parameter, by up to {:.0f}.",
                     higher, all, most);
}

Chart speed_gap_chart(const BiasStudy& study) {
  const std::size_t usual = usual_of(study.plan);
  const SpeedError error = speed_error(study, usual);
  Chart chart{.name = "speed-gap",
              .title = fmt::format(
                  "At smoothing parameter {:g} the top speed in the window is {:.2f} rad/s "
                  "off at worst, {:.2f} in the median",
                  study.plan.smoothings[usual], error.worst, error.median),
              .x = {"smoothing parameter", Scale::logarithmic},
              .y = {"off by [rad/s]"},
              .width = 760,
              .height = 340};
  for (const CaseBias& row : study.cases) {
    Series& series = chart.series.emplace_back(Series{row.id, report::Mark::line, {}});
    for (const Bias& bias : row.biases) {
      const auto gap = bias.speed_optimality_gap;
      series.samples.push_back({bias.smoothing, gap ? std::optional(std::abs(*gap)) : gap});
    }
    std::ranges::reverse(series.samples);
  }
  return chart;
}

}  // namespace

void add_to(report::Results& results, const BiasStudy& study) {
  Table biases{"bias",
               {{"case"},
                {"lowest", "lowest count"},
                {"fastest", "truly quiet up to [rad/s]", ".2f"},
                {"smoothing", "smoothing parameter", "g"},
                {"error", "mean distance from the count", ".3f", 4},
                {"rank_correlation", "rank correlation", ".4f"},
                {"count_optimality_gap", "count at its minimum, above the lowest", ".0f"},
                {"speed", "fastest speed it calls quiet [rad/s]", ".2f"},
                {"speed_optimality_gap", "short of the true one by [rad/s]", "+.2f"},
                {"quiet", "truly quiet there"}}};
  Table speeds{"quiet-speeds", {{"case"}, {"fastest", "truly", ".2f"}}};
  for (const double smoothing : study.plan.smoothings) {
    speeds.columns.push_back(
        {fmt::format("at_{:g}", smoothing), fmt::format("at {:g}", smoothing), ".2f"});
  }
  for (const CaseBias& row : study.cases) {
    std::vector<Value> cells = {value_of(row.id), value_of(row.fastest)};
    for (const Bias& bias : row.biases) {
      biases.add(row.id, row.lowest, row.fastest, bias.smoothing, bias.error, bias.rank_correlation,
                 bias.count_optimality_gap, bias.speed, bias.speed_optimality_gap,
                 bias.speed ? std::optional(!bias.loud) : std::nullopt);
      cells.push_back(value_of(bias.speed));
    }
    speeds.add_row(std::move(cells));
  }
  results.set("finding", finding_of(study));
  results.set("bias-side", side_of(study));
  results.set("at-minimum", at_minimum(study));
  results.set("speeds", std::lround(fastest_speed / study.plan.step));
  results.add(std::move(biases));
  results.add(std::move(speeds));
  results.add(speed_gap_chart(study));
}

}  // namespace ricochet::studies::surrogate
