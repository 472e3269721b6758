#pragma once

#include <memory>

#include "src/core/problem.h"

namespace ricochet {

/// What comes between a solver and the functions of a problem, during one run. Each member is asked
/// for one of them, at a solver's x, and passes it on as it is unless it does something about it.
class Perturbation {
 public:
  Perturbation() = default;
  virtual ~Perturbation() = default;
  Perturbation(const Perturbation&) = delete;
  Perturbation& operator=(const Perturbation&) = delete;

  virtual Values values(const Problem& shown, const Vector& x);
  virtual Derivatives derivatives(const Problem& shown, const Vector& x);
  virtual Residuals residuals(const Problem& shown, const Vector& x);
  virtual Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                         const Vector& multipliers);

  /// Whatever solvers are shown, this is what the problem itself says.
  virtual Truth truth(const Problem& shown, const Vector& x);
};

/// The problem, and what it shows at any smoothing width, behind the perturbation. All that share
/// one share its state. Where what is shown is the truth, it is not computed a second time for the
/// judge.
Problem perturbed_by(const std::shared_ptr<Perturbation>& perturbation, const Problem& shown);

}  // namespace ricochet
