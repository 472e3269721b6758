#include "ricochet/problem.h"

#include <cmath>

namespace ricochet {

TrueValues true_values_at(const Problem& problem, const Vector& x) {
  return problem.true_values ? problem.true_values(x)
                             : true_values_of(problem.evaluate(x), problem.equalities);
}

TrueValues true_values_of(const Values& values, Eigen::Index equalities) {
  double violation = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    double excess = values.constraints[i];
    if (i < equalities) {
      excess = std::abs(excess);
      if (excess <= equality_tolerance) continue;
    }
    // NaN stays NaN, so that the point is not feasible.
    if (excess > violation || std::isnan(excess)) violation = excess;
  }
  return {values.objective, violation};
}

bool better(const TrueValues& a, const TrueValues& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace ricochet
