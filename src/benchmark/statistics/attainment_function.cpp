#include "src/benchmark/statistics/attainment_function.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "src/benchmark/statistics/mean_share.h"

namespace ricochet {
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

}  // namespace ricochet
