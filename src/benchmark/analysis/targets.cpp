#include "src/benchmark/analysis/targets.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "src/benchmark/statistics/bootstrap.h"
#include "src/core/instance.h"
#include "src/core/seed.h"

namespace ricochet::comparison {
namespace {

constexpr int points = 15;
constexpr int precisions = 51;

std::optional<TrueValues> values_at(const Problem& problem, const Vector& x) {
  try {
    const TrueValues values = true_values_at(problem, x);
    const bool finite = std::isfinite(values.objective) && !std::isnan(values.violation);
    return finite ? std::optional(values) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // no solver gets a value there either
  }
}

}  // namespace

double reference_gap(const Problem& problem) {
  Random random(seed_of(problem.name, "targets", 0, 0));
  std::vector<double> feasible;
  std::vector<double> sizes;
  for (int k = 0; k < points; ++k) {
    const auto values = values_at(problem, uniform_point(problem, random));
    if (!values) continue;
    const double gap = values->objective - problem.best_known.value();
    if (values->violation <= 0) feasible.push_back(gap);
    sizes.push_back(std::abs(gap));
  }
  if (sizes.empty()) return 0;
  return quantile(feasible.empty() ? sizes : feasible, 0.5);
}

Targets targets_of(const Problem& problem) {
  const double tolerance = problem.tolerance;
  const double reference = reference_gap(problem);
  Targets targets{tolerance};
  if (tolerance == 0.5) {
    while (targets.back() + 1 < reference) targets.push_back(targets.back() + 1);
    return targets;
  }
  // A tolerance of 0 has no logarithm: the precision of a double below the reference.
  const double least = std::max(tolerance, 1e-16 * reference);
  if (!(reference > least)) return targets;
  for (int k = 1; k < precisions; ++k) {
    targets.push_back(least * std::pow(reference / least, k / (precisions - 1.0)));
  }
  return targets;
}

double share_reached(const Targets& targets, double gap) {
  const auto reached = targets.end() - std::lower_bound(targets.begin(), targets.end(), gap);
  return static_cast<double>(reached) / static_cast<double>(targets.size());
}

}  // namespace ricochet::comparison
