#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/core/fields.h"

namespace ricochet {

/// Termination reason of a solver that ended because the evaluator refused.
inline constexpr const char* stopped_by_evaluator = "stopped by the evaluator";

/// Termination reason of a solver that ended because one of its numbers, or of the problem's, is
/// not finite.
inline constexpr const char* not_finite = "a number is not finite";

/// The coordinates u that a solver works in.
enum class Coordinates {
  unit,  ///< the box is the unit cube: one step and one tolerance suit every coordinate
  even,  ///< divided by the longest side of the box: sides and gradients keep their ratios
  own,   ///< those of the problem, u = x
};
EnumNames<Coordinates> names_of(Coordinates of);

/// An evaluator in the coordinates of a solver: x = origin + scale * u.
class ScaledBox {
 public:
  explicit ScaledBox(Evaluator& evaluator, Coordinates coordinates = Coordinates::unit);

  const Vector& lower() const { return lower_; }  ///< the box in u
  const Vector& upper() const { return upper_; }
  const Vector& scale() const { return scale_; }  ///< dx / du

  /// The u of a point, moved into the box. A coordinate without width has u = 0 in [0, 1] and a
  /// scale of 0, since libraries refuse equal bounds.
  Vector to_scaled(const Vector& x) const;
  Vector from_scaled(const Vector& u) const;

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
  Vector origin_, scale_, lower_, upper_;
};

/// Returns true if objective and constraints are finite.
bool finite(const Values& values);

/// Returns true if values and derivatives are finite.
bool finite(const Derivatives& derivatives);

/// Returns true if the residuals and their derivatives are finite.
bool finite(const Residuals& residuals);

// Multi-objective optimisation: all goals are minimised; the result is a Pareto front.

/// Goals over the unit cube. `evaluate` returns one finite number for each goal.
struct SeveralGoals {
  Eigen::Index variables;
  Eigen::Index goals;
  std::function<Vector(const Vector& u)> evaluate;
};

struct FrontPoint {
  Vector u;  ///< in the unit cube
  Vector goals;
};

/// Mutually non-dominated points, in the order in which they were found.
using Front = std::vector<FrontPoint>;

/// Returns true if `a` is nowhere worse than `b`, and somewhere better.
bool dominates(const Vector& a, const Vector& b);

/// Adds the point, unless a point of the front is as good in every goal, and removes the points
/// that it dominates.
void add(Front& front, FrontPoint point);

struct FrontSearch {
  int population;      ///< a multiple of 4, at least 8
  int generations;     ///< after the first, which is `starts` and points uniform in the cube
  std::uint64_t seed;  ///< the same seed gives the same front
  std::vector<Vector> starts;  ///< at most `population` points
};

/// The front of all points that NSGA-II (Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182-197;
/// doi 10.1109/4235.996017) evaluates: (generations + 1) times the population. Exceptions of
/// `evaluate` are passed on. Throws InputError if this build has no pagmo.
Front nsga2_front(const SeveralGoals& problem, const FrontSearch& search);

/// The hypervolume that the front dominates below the reference. Points that are not better than
/// the reference in every goal add nothing. Throws InputError if this build has no pagmo.
double hypervolume(const Front& front, const Vector& reference);

}  // namespace ricochet
