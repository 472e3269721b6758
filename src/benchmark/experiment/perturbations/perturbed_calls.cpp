#include "src/benchmark/experiment/perturbations/perturbed_calls.h"

namespace ricochet {
namespace {

/// The problem with true values of its own, taken from the values it shows. It remembers the last
/// point, because the evaluator scores the point that the solver has just evaluated.
Problem with_true_values(const Problem& problem) {
  if (problem.true_values) return problem;
  struct Seen {
    Vector x;
    TrueValues true_values;
  };
  const auto seen = std::make_shared<Seen>();
  const Eigen::Index equalities = problem.equalities;
  const auto remember = [seen, equalities](const Vector& x, const Values& values) {
    seen->x = x;
    seen->true_values = true_values_of(values, equalities);
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
  result.true_values = [evaluate = problem.evaluate, seen, equalities](const Vector& x) {
    const bool known = seen->x.size() == x.size() && seen->x == x;
    return known ? seen->true_values : true_values_of(evaluate(x), equalities);
  };
  return result;
}

}  // namespace

Values PerturbedCalls::values(const Problem& shown, const Vector& x) {
  return shown.evaluate(x);
}

Derivatives PerturbedCalls::derivatives(const Problem& shown, const Vector& x) {
  return shown.differentiate(x);
}

Residuals PerturbedCalls::residuals(const Problem& shown, const Vector& x) {
  return shown.residuals(x);
}

Matrix PerturbedCalls::hessian(const Problem& shown, const Vector& x, double objective_factor,
                               const Vector& multipliers) {
  return shown.lagrangian_hessian(x, objective_factor, multipliers);
}

TrueValues PerturbedCalls::true_values(const Problem& shown, const Vector& x) {
  return shown.true_values(x);
}

Problem perturbed_by(const std::shared_ptr<PerturbedCalls>& perturbation, const Problem& shown) {
  const auto original = std::make_shared<const Problem>(with_true_values(shown));
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
  result.true_values = [original, perturbation](const Vector& x) {
    return perturbation->true_values(*original, x);
  };
  if (shown.smoothed) {
    result.smoothed = [smoothed = shown.smoothed, perturbation](double width) {
      return perturbed_by(perturbation, smoothed(width));
    };
  }
  return result;
}

}  // namespace ricochet
