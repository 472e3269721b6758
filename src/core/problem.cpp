#include "src/core/problem.h"

#include <cmath>

namespace ricochet {

Truth truth_at(const Problem& problem, const Vector& x) {
  return problem.truth ? problem.truth(x) : truth_of(problem.evaluate(x), problem.equalities);
}

Truth truth_of(const Values& values, Eigen::Index equalities) {
  double violation = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    double excess = values.constraints[i];
    if (i < equalities) {
      excess = std::abs(excess);
      if (excess <= equality_tolerance) continue;
    }
    // What is not a number stays, and is no feasible point.
    if (excess > violation || std::isnan(excess)) violation = excess;
  }
  return {values.objective, violation};
}

bool better(const Truth& a, const Truth& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace ricochet
