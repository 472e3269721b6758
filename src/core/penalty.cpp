#include "src/core/penalty.h"

namespace ricochet {
namespace {

/// The violations of the constraints, with their sign.
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
  if (problem.lagrangian_hessian) {
    result.lagrangian_hessian = [hessian = problem.lagrangian_hessian, evaluate = problem.evaluate,
                                 weight, m = problem.equalities](
                                    const Vector& x, double objective_factor, const Vector&) {
      const Vector sides = broken(evaluate(x).constraints, m).cwiseSign();
      return hessian(x, objective_factor, objective_factor * weight * sides);
    };
  }
  result.residuals = nullptr;
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, weight](double smoothing) {
      return penalised(smoothed(smoothing), weight);
    };
  }
  if (!problem.true_values) {
    result.true_values = [evaluate = problem.evaluate, m = problem.equalities](const Vector& x) {
      return true_values_of(evaluate(x), m);
    };
  }
  return result;
}

}  // namespace ricochet
