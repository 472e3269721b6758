#include "src/core/penalty.h"

namespace ricochet {
namespace {

/// What the constraints are broken by, with its sign.
Vector broken(const Vector& constraints, Eigen::Index equalities) {
  Vector result = constraints;
  const Eigen::Index inequalities = result.size() - equalities;
  result.tail(inequalities) = result.tail(inequalities).cwiseMax(0);
  return result;
}

}  // namespace

Problem penalised(const Problem& problem, double weight) {
  Problem result = problem;
  result.constraints = result.equalities = 0;
  const auto penalise = [weight, m = problem.equalities](const Values& values) {
    return Values{values.objective + weight * broken(values.constraints, m).lpNorm<1>(), {}};
  };
  result.evaluate = [evaluate = problem.evaluate, penalise](const Vector& x) {
    return penalise(evaluate(x));
  };
  if (problem.differentiate) {
    result.differentiate = [differentiate = problem.differentiate, penalise, weight,
                            m = problem.equalities](const Vector& x) {
      const Derivatives d = differentiate(x);
      const Vector sides = broken(d.values.constraints, m).cwiseSign();
      return Derivatives{penalise(d.values), d.gradient + weight * d.jacobian.transpose() * sides,
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
    result.truth = [evaluate = problem.evaluate, m = problem.equalities](const Vector& x) {
      return truth_of(evaluate(x), m);
    };
  }
  return result;
}

}  // namespace ricochet
