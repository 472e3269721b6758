#include "src/benchmark/statistics/log_ratio_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace ricochet {
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
