#include "ricochet/problem.h"

#include <cmath>

namespace ricochet {

double violation_of(double constraint, bool is_equality) {
  const double excess = is_equality ? std::abs(constraint) : constraint;
  return excess <= constraint_tolerance ? 0 : excess;
}

TrueValues true_values_at(const Problem& problem, const Vector& x) {
  return problem.true_values ? problem.true_values(x)
                             : true_values_of(problem.evaluate(x), problem.equalities);
}

TrueValues true_values_of(const Values& values, Eigen::Index equalities) {
  double violation = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    const double broken_by = violation_of(values.constraints[i], i < equalities);
    // NaN stays NaN, so that the point is not feasible.
    if (broken_by > violation || std::isnan(broken_by)) violation = broken_by;
  }
  return {values.objective, violation};
}

bool better(const TrueValues& a, const TrueValues& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace ricochet
