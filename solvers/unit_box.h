#pragma once

#include <optional>

#include "ricochet/evaluator.h"
#include "ricochet/solver.h"

namespace ricochet {

/// Termination reason of a solver that ended because the evaluator refused.
inline constexpr const char* stopped_by_evaluator = "stopped by the evaluator";

/// Termination reason of a solver that ended because one of its numbers, or of the problem's, is
/// not finite.
inline constexpr const char* not_finite = "a number is not finite";

/// An evaluator over the unit cube, u = (x - lower) / (upper - lower), so that one step and one
/// tolerance suit every coordinate of every problem.
class UnitBox {
 public:
  explicit UnitBox(Evaluator& evaluator);

  /// The u of a point of the box; 0 in a coordinate whose box has width 0.
  Vector to_unit(const Vector& x) const;
  Vector from_unit(const Vector& u) const;

  /// Objective and constraints at u. Nothing once the run is over, or if u is not finite: the
  /// evaluator would end the run, but only this start has failed.
  std::optional<Values> values(const Vector& u, Part part = Part::everything);

  /// The same with derivatives with respect to u.
  std::optional<Derivatives> derivatives(const Vector& u, Part part = Part::everything);

  /// The second derivatives of the Lagrangian with respect to u, charged as by the evaluator.
  std::optional<Matrix> lagrangian_hessian(const Vector& u, double objective_factor,
                                           const Vector& multipliers);

  /// The residuals with their derivatives with respect to u.
  std::optional<Residuals> residuals(const Vector& u, Part part = Part::everything);
  /// The residuals alone; see Evaluator::residual_values.
  std::optional<Vector> residual_values(const Vector& u, Part part = Part::objective);

  const Evaluator& evaluator() const { return evaluator_; }
  bool over() const { return evaluator_.over(); }

 private:
  Evaluator& evaluator_;
  Vector lower_, width_;
};

/// Returns true if objective and constraints are finite.
bool finite(const Values& values);

/// Returns true if values and derivatives are finite.
bool finite(const Derivatives& derivatives);

/// Returns true if the residuals and their derivatives are finite.
bool finite(const Residuals& residuals);

}  // namespace ricochet
