#include "src/analysis/statistics/attainment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "src/analysis/statistics/intervals.h"

namespace ricochet {

namespace {

void check(const History& history, const Levels& levels) {
  if (!(levels.lower < levels.upper))
    throw std::invalid_argument("levels: lower < upper is needed");
  check_history(history);
}

double reached(const Levels& levels, double value) {
  return (levels.upper - std::clamp(value, levels.lower, levels.upper)) /
         (levels.upper - levels.lower);
}

}  // namespace

void check_history(const History& history) {
  for (std::size_t i = 0; i < history.size(); ++i) {
    const bool fits = i == 0 ? history[i].evaluations >= 1 && !std::isnan(history[i].value)
                             : history[i].evaluations > history[i - 1].evaluations &&
                                   history[i].value < history[i - 1].value;
    if (!fits) throw std::invalid_argument("history: evaluations must rise and values fall");
  }
}

double attainment(const History& history, const Levels& levels, double t) {
  check(history, levels);
  double share = 0;
  for (const BestSoFar& best : history) {
    if (best.evaluations <= t) share = reached(levels, best.value);
  }
  return share;
}

double area_over_convergence_curve(const History& history, const Levels& levels, double budget,
                                   EvaluationAxis axis) {
  check(history, levels);
  if (!(budget >= 1)) throw std::invalid_argument("area_over_convergence_curve: budget < 1");
  // Evaluation t extends from t to t + 1 on the axis.
  const auto place = [&](double t) { return axis == EvaluationAxis::linear ? t - 1 : std::log(t); };
  const double end = place(budget + 1);
  double area = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double from = std::min(end, place(history[i].evaluations));
    const double to =
        i + 1 < history.size() ? std::min(end, place(history[i + 1].evaluations)) : end;
    area += reached(levels, history[i].value) * (to - from);
  }
  return area / end;
}

namespace {

void check(const RunsOfUnits& runs) {
  if (runs.empty()) throw std::invalid_argument("attainment function: no units");
  for (const std::vector<History>& unit : runs) {
    if (unit.empty()) throw std::invalid_argument("attainment function: a unit without runs");
    for (const History& history : unit) check_history(history);
  }
}

/// The best value after each of these numbers of evaluations, by unit and run.
using BestAt = std::vector<std::vector<double>>;

BestAt best_at(const RunsOfUnits& runs, double evaluations) {
  BestAt best;
  for (const std::vector<History>& unit : runs) {
    best.emplace_back();
    for (const History& history : unit) {
      const auto next = std::upper_bound(
          history.begin(), history.end(), evaluations,
          [](double t, const BestSoFar& improvement) { return t < improvement.evaluations; });
      best.back().push_back(next == history.begin() ? std::numeric_limits<double>::infinity()
                                                    : std::prev(next)->value);
    }
  }
  return best;
}

double share_of_unit(const std::vector<double>& best, double value) {
  const auto attained =
      std::count_if(best.begin(), best.end(), [&](double x) { return x <= value; });
  return static_cast<double>(attained) / static_cast<double>(best.size());
}

}  // namespace

std::vector<std::vector<Attained>> attainment_function(const RunsOfUnits& runs,
                                                       const AttainmentGrid& grid,
                                                       double confidence) {
  check(runs);
  std::vector<std::vector<Attained>> attained;
  std::vector<double> shares(runs.size());
  for (const double t : grid.evaluations) {
    const BestAt best = best_at(runs, t);
    attained.emplace_back();
    for (const double value : grid.values) {
      for (std::size_t u = 0; u < runs.size(); ++u) shares[u] = share_of_unit(best[u], value);
      const MeanShare share = mean_share(shares, confidence);
      attained.back().push_back({share.mean, share.interval});
    }
  }
  return attained;
}

std::vector<std::vector<Attained>> attainment_difference(const RunsOfUnits& a, const RunsOfUnits& b,
                                                         const AttainmentGrid& grid,
                                                         double confidence) {
  check(a);
  check(b);
  if (a.size() != b.size()) {
    throw std::invalid_argument("attainment_difference: both need the same units");
  }
  std::vector<std::vector<Attained>> differences;
  std::vector<double> shares(a.size());  // (1 + difference) / 2, in [0, 1]
  const auto back = [](double share) { return 2 * share - 1; };
  for (const double t : grid.evaluations) {
    const BestAt best_of_a = best_at(a, t);
    const BestAt best_of_b = best_at(b, t);
    differences.emplace_back();
    for (const double value : grid.values) {
      for (std::size_t u = 0; u < a.size(); ++u) {
        shares[u] =
            (1 + share_of_unit(best_of_a[u], value) - share_of_unit(best_of_b[u], value)) / 2;
      }
      const MeanShare share = mean_share(shares, confidence);
      differences.back().push_back(
          {back(share.mean), {back(share.interval.lower), back(share.interval.upper)}});
    }
  }
  return differences;
}

MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 double confidence) {
  std::vector<double> shares;
  for (const std::vector<double>& times : hitting_times) {
    if (times.empty() ||
        std::any_of(times.begin(), times.end(), [](double x) { return std::isnan(x); })) {
      throw std::invalid_argument("empirical_distribution: a problem has no times, or not numbers");
    }
    const auto reached = std::count_if(times.begin(), times.end(),
                                       [&](double x) { return x <= t && !std::isinf(x); });
    shares.push_back(static_cast<double>(reached) / static_cast<double>(times.size()));
  }
  return mean_share(shares, confidence);
}

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double ratio_of(double cost, double reference) {
  return std::isinf(cost) ? never : cost / reference;
}

}  // namespace

Costs performance_ratios(const Costs& costs) {
  check_costs(costs);
  Costs ratios = costs;
  for (std::vector<double>& row : ratios) {
    const double least = *std::min_element(row.begin(), row.end());
    for (double& cost : row) cost = ratio_of(cost, least);
  }
  return ratios;
}

Costs extended_performance_ratios(const Costs& costs) {
  if (check_costs(costs) < 2) {
    throw std::invalid_argument("extended_performance_ratios: two solvers are needed");
  }
  Costs ratios = costs;
  for (std::vector<double>& row : ratios) {
    std::vector<double> two(
        2);  // the least and the second least cost, which a winner is compared with
    std::partial_sort_copy(row.begin(), row.end(), two.begin(), two.end());
    for (double& cost : row) cost = ratio_of(cost, cost == two[0] ? two[1] : two[0]);
  }
  return ratios;
}

MeanShare performance_profile(const Costs& ratios, std::size_t solver, double ratio,
                              double confidence) {
  std::vector<double> within;
  for (const std::vector<double>& row : ratios) {
    if (solver >= row.size() || row.size() != ratios.front().size() || !(row[solver] >= 0)) {
      throw std::invalid_argument("performance_profile: ratios >= 0 of every solver are needed");
    }
    within.push_back(std::isfinite(row[solver]) && row[solver] <= ratio ? 1 : 0);
  }
  return mean_share(within, confidence);
}

namespace {

SolvedBy solved_by(double a, double b) {
  if (std::isinf(a)) return std::isinf(b) ? SolvedBy::neither : SolvedBy::only_b;
  return std::isinf(b) ? SolvedBy::only_a : SolvedBy::both;
}

/// Sort key: bars of problems that neither solved are the first on the left or the last on the
/// right.
auto key(const LogRatio& bar) {
  const double side = bar.solved_by != SolvedBy::neither ? 0 : bar.log2_ratio < 0 ? -1 : 1;
  return std::tuple(bar.log2_ratio, side, bar.problem);
}

}  // namespace

std::vector<LogRatio> log_ratio_profile(const std::vector<double>& costs_of_a,
                                        const std::vector<double>& costs_of_b) {
  if (costs_of_a.empty() || costs_of_a.size() != costs_of_b.size()) {
    throw std::invalid_argument("log_ratio_profile: costs of both solvers on the same problems");
  }
  std::vector<LogRatio> bars;
  double largest = 0;
  for (std::size_t k = 0; k < costs_of_a.size(); ++k) {
    const double a = costs_of_a[k];
    const double b = costs_of_b[k];
    if (!(a > 0 && b > 0)) throw std::invalid_argument("log_ratio_profile: a cost must be > 0");
    bars.push_back({k, 0, solved_by(a, b)});
    if (bars.back().solved_by != SolvedBy::both) continue;
    bars.back().log2_ratio = std::log2(a) - std::log2(b);
    largest = std::max(largest, std::abs(bars.back().log2_ratio));
  }
  const double failure = 1.1 * (largest > 0 ? largest : 1);
  for (std::size_t k = 0; k < costs_of_a.size(); ++k) {
    if (bars[k].solved_by == SolvedBy::both) continue;
    bars[k].log2_ratio = bars[k].solved_by == SolvedBy::only_a ? -failure : failure;
    if (bars[k].solved_by == SolvedBy::neither) bars.push_back({k, -failure, SolvedBy::neither});
  }
  std::sort(bars.begin(), bars.end(),
            [](const LogRatio& x, const LogRatio& y) { return key(x) < key(y); });
  return bars;
}

}  // namespace ricochet
