#include "src/core/penalty.h"

namespace ricochet {
namespace {

Values penalise(const Values& values, double weight) {
  return {values.objective + weight * values.constraints.cwiseMax(0).sum(), {}};
}

}  // namespace

Problem penalised(const Problem& problem, double weight) {
  Problem result = problem;
  result.name += "-penalised";
  result.constraints = 0;
  result.evaluate = [evaluate = problem.evaluate, weight](const Vector& x) {
    return penalise(evaluate(x), weight);
  };
  if (problem.differentiate) {
    result.differentiate = [differentiate = problem.differentiate, weight](const Vector& x) {
      const Derivatives d = differentiate(x);
      const Vector violated = (d.values.constraints.array() > 0).cast<double>();
      return Derivatives{penalise(d.values, weight),
                         d.gradient + weight * d.jacobian.transpose() * violated,
                         Matrix(0, d.gradient.size()), d.trust};
    };
  }
  result.residuals = nullptr;
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, weight](double width) {
      return penalised(smoothed(width), weight);
    };
  }
  if (!problem.truth) {
    result.truth = [evaluate = problem.evaluate](const Vector& x) { return truth_of(evaluate(x)); };
  }
  return result;
}

}  // namespace ricochet
