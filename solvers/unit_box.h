#pragma once

#include <optional>

#include "src/core/evaluator.h"
#include "src/core/solver.h"

namespace ricochet {

/// What a solver says when it ended because the evaluator refused.
inline constexpr const char* stopped_by_evaluator = "stopped by the evaluator";

/// What a solver says when it ended because it, or the problem, lost its numbers.
inline constexpr const char* not_finite = "a number is not finite";

/// How far inside the feasible set the solvers of libraries are kept. They converge to a violation
/// of about their tolerance, but the verdict grants none.
inline constexpr double feasibility_margin = 1e-8;

/// Whether the box holds more than one point. In one that does not there is nothing to search.
bool has_room(const Problem& problem);

/// An evaluator seen through the unit cube, u = (x - lower) / (upper - lower), so that one step and
/// one tolerance suit every coordinate of every problem.
class UnitBox {
 public:
  explicit UnitBox(Evaluator& evaluator);

  /// The u of a point of the box; 0 in a coordinate whose box has no width.
  Vector to_unit(const Vector& x) const;
  Vector from_unit(const Vector& u) const;

  /// Objective and constraints at u, but equalities, raised by feasibility_margin. Nothing once the
  /// run is over, or where u is not finite: the evaluator would end the run, but only this start
  /// has failed.
  std::optional<Values> values(const Vector& u, Part part = Part::everything);

  /// The same with the derivatives with respect to u.
  std::optional<Derivatives> derivatives(const Vector& u, Part part = Part::everything);

  /// The second derivatives of the Lagrangian with respect to u, as the evaluator charges them.
  std::optional<Matrix> lagrangian_hessian(const Vector& u, double objective_factor,
                                           const Vector& multipliers);

  /// The residuals with their derivatives with respect to u.
  std::optional<Residuals> residuals(const Vector& u, Part part = Part::everything);
  /// The residuals alone; see Evaluator::residual_values.
  std::optional<Vector> residual_values(const Vector& u, Part part = Part::objective);

  bool over() const { return evaluator_.over(); }

 private:
  void keep_inside(Values& values) const;

  Evaluator& evaluator_;
  Vector lower_, width_;
};

/// Whether objective and constraints are numbers.
bool finite(const Values& values);

/// Whether the derivatives are, too.
bool finite(const Derivatives& derivatives);

/// Whether the residuals and their derivatives are.
bool finite(const Residuals& residuals);

}  // namespace ricochet
