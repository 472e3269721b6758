#include "src/core/problem.h"

#include <algorithm>

namespace ricochet {

Truth truth_of(const Values& values) {
  const double violation = values.constraints.size() > 0 ? values.constraints.maxCoeff() : 0.0;
  return {values.objective, std::max(0.0, violation)};
}

bool better(const Truth& a, const Truth& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace ricochet
