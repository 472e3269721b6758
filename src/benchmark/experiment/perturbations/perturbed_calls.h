#pragma once

#include <memory>

#include "ricochet/problem.h"

namespace ricochet {

/// Stands between a solver and the functions of a problem, during one run. Each member evaluates
/// one of them at a solver's x and returns it unchanged unless it is overridden.
class PerturbedCalls {
 public:
  PerturbedCalls() = default;
  virtual ~PerturbedCalls() = default;
  PerturbedCalls(const PerturbedCalls&) = delete;
  PerturbedCalls& operator=(const PerturbedCalls&) = delete;

  virtual Values values(const Problem& shown, const Vector& x);
  virtual Derivatives derivatives(const Problem& shown, const Vector& x);
  virtual Residuals residuals(const Problem& shown, const Vector& x);
  virtual Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                         const Vector& multipliers);

  /// Always the problem's own true values, whatever solvers are shown.
  virtual TrueValues true_values(const Problem& shown, const Vector& x);
};

/// The problem, and its surrogate at any smoothing parameter, with the perturbation. Problems with
/// the same perturbation object share its state. If the values shown are the true ones, they are
/// not computed a second time for scoring.
Problem perturbed_by(const std::shared_ptr<PerturbedCalls>& perturbation, const Problem& shown);

}  // namespace ricochet
