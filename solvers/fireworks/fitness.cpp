#include "solvers/fireworks/fitness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::fireworks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bound on the size of numbers: sums and differences of a few such numbers stay finite.
constexpr double largest = 1e300;

double usable(double value) {
  return std::abs(value) < largest ? value : infinity;
}

}  // namespace

TrueValues worth_of(const Values& values, Eigen::Index equalities) {
  const TrueValues true_values = true_values_of(values, equalities);
  return {usable(true_values.objective), usable(true_values.violation)};
}

Vector fitness_of(std::span<const TrueValues> worths) {
  double worst_feasible = -infinity;
  for (const TrueValues& worth : worths) {
    if (worth.violation == 0 && worth.objective < infinity) {
      worst_feasible = std::max(worst_feasible, worth.objective);
    }
  }
  if (worst_feasible == -infinity) worst_feasible = 0;
  Vector fitness(static_cast<Eigen::Index>(worths.size()));
  double worst = -infinity;
  for (Eigen::Index i = 0; i < fitness.size(); ++i) {
    const TrueValues& worth = worths[static_cast<std::size_t>(i)];
    fitness[i] = worth.violation > 0 ? worst_feasible + worth.violation : worth.objective;
    if (fitness[i] < infinity) worst = std::max(worst, fitness[i]);
  }
  if (worst == -infinity) worst = 0;
  return fitness.cwiseMin(worst);
}

}  // namespace ricochet::fireworks
