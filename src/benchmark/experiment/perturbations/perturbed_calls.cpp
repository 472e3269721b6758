#include "src/features/perturbation.h"

namespace ricochet {
namespace {

/// The problem with a truth of its own: that of what it tells, remembered from one point to the
/// next, because the judge asks where the solver has just asked.
Problem with_truth(const Problem& problem) {
  if (problem.truth) return problem;
  struct Seen {
    Vector x;
    Truth truth;
  };
  const auto seen = std::make_shared<Seen>();
  const Eigen::Index equalities = problem.equalities;
  const auto remember = [seen, equalities](const Vector& x, const Values& values) {
    seen->x = x;
    seen->truth = truth_of(values, equalities);
  };
  Problem result = problem;
  result.evaluate = [evaluate = problem.evaluate, remember](const Vector& x) {
    Values values = evaluate(x);
    remember(x, values);
    return values;
  };
  if (problem.differentiate) {
    result.differentiate = [differentiate = problem.differentiate, remember](const Vector& x) {
      Derivatives derivatives = differentiate(x);
      remember(x, derivatives.values);
      return derivatives;
    };
  }
  result.truth = [evaluate = problem.evaluate, seen, equalities](const Vector& x) {
    const bool known = seen->x.size() == x.size() && seen->x == x;
    return known ? seen->truth : truth_of(evaluate(x), equalities);
  };
  return result;
}

}  // namespace

Values Perturbation::values(const Problem& shown, const Vector& x) {
  return shown.evaluate(x);
}

Derivatives Perturbation::derivatives(const Problem& shown, const Vector& x) {
  return shown.differentiate(x);
}

Residuals Perturbation::residuals(const Problem& shown, const Vector& x) {
  return shown.residuals(x);
}

Matrix Perturbation::hessian(const Problem& shown, const Vector& x, double objective_factor,
                             const Vector& multipliers) {
  return shown.lagrangian_hessian(x, objective_factor, multipliers);
}

Truth Perturbation::truth(const Problem& shown, const Vector& x) {
  return shown.truth(x);
}

Problem perturbed_by(const std::shared_ptr<Perturbation>& perturbation, const Problem& shown) {
  const auto original = std::make_shared<const Problem>(with_truth(shown));
  Problem result = shown;
  result.evaluate = [original, perturbation](const Vector& x) {
    return perturbation->values(*original, x);
  };
  if (shown.differentiate) {
    result.differentiate = [original, perturbation](const Vector& x) {
      return perturbation->derivatives(*original, x);
    };
  }
  if (shown.residuals) {
    result.residuals = [original, perturbation](const Vector& x) {
      return perturbation->residuals(*original, x);
    };
  }
  if (shown.lagrangian_hessian) {
    result.lagrangian_hessian = [original, perturbation](const Vector& x, double objective_factor,
                                                         const Vector& multipliers) {
      return perturbation->hessian(*original, x, objective_factor, multipliers);
    };
  }
  result.truth = [original, perturbation](const Vector& x) {
    return perturbation->truth(*original, x);
  };
  if (shown.smoothed) {
    result.smoothed = [smoothed = shown.smoothed, perturbation](double width) {
      return perturbed_by(perturbation, smoothed(width));
    };
  }
  return result;
}

}  // namespace ricochet
