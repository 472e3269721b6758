#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "src/core/vector.h"

namespace ricochet {

/// Objective and constraints at one point; a point is feasible where the equalities, which come
/// first, are 0 and every other constraint is <= 0.
struct Values {
  double objective = 0;
  Vector constraints;  ///< length Problem::constraints
};

/// Why an exact gradient tells less than it seems to.
enum class GradientDoubt {
  none,       ///< no reason known
  flat,       ///< it is zero, or would change the function by next to nothing across the box
  kink,       ///< the function has a corner, or an infinite slope, next to the point
  sensitive,  ///< the point's digits are lost on the way to the value
};

/// How far a gradient can be believed. Problems that know nothing of it leave it as it is.
struct Trust {
  /// How far from the point the function stays smooth, to first order, in the box's own measure: a
  /// box has width 1 in every coordinate.
  double reach = std::numeric_limits<double>::infinity();
  GradientDoubt doubt = GradientDoubt::none;
};

struct Derivatives {
  Values values;
  Vector gradient;  ///< of the objective, length n
  Matrix jacobian;  ///< of the constraints, Problem::constraints x n
  Trust trust = {};
};

/// The objective as a solver for least squares sees it: half the sum of the squares of `values`.
struct Residuals {
  Vector values;    ///< at least one, as many at every point
  Matrix jacobian;  ///< residuals x n
};

/// An equality holds where it is not further from 0 than this: rounding breaks every equation.
inline constexpr double equality_tolerance = 1e-6;

/// What a point is really worth, whatever the solver was shown.
struct Truth {
  double objective = 0;
  double violation = 0;  ///< largest true constraint value, of an equality its size; 0 if feasible
};

/// What a coordinate is.
struct Variable {
  std::string name;  ///< e.g. "omega"
  std::string unit;  ///< empty where it has none
};

/// A minimisation problem within a box. Immutable once built; runs own all state. The functions may
/// be called from several threads at once. They throw what went wrong; the evaluator catches it.
struct Problem {
  std::string name;                 ///< e.g. "count-C1"
  std::string source;               ///< what it is, and where it comes from
  int instance = 0;                 ///< 0 is the problem as stated; see instance.h
  std::vector<Variable> variables;  ///< one a coordinate, or none where they have no names
  Vector lower, upper, start;
  Eigen::Index constraints = 0;
  Eigen::Index equalities = 0;  ///< so many of the constraints, the first ones, must be 0

  /// What a solver sees.
  std::function<Values(const Vector&)> evaluate;
  /// Values and first derivatives in one call; empty where the problem has none.
  std::function<Derivatives(const Vector&)> differentiate;
  /// Second derivatives, n x n and symmetric, of the Lagrangian: objective_factor times the
  /// objective, plus every constraint times its multiplier, of which there are
  /// Problem::constraints. Empty where the problem has none.
  std::function<Matrix(const Vector& x, double objective_factor, const Vector& multipliers)>
      lagrangian_hessian;
  /// Residuals and first derivatives in one call; empty where the problem is no sum of squares.
  /// Theirs may be a smooth stand-in for the objective.
  std::function<Residuals(const Vector&)> residuals;
  /// What the suite judges by; empty where `evaluate` is the truth.
  std::function<Truth(const Vector&)> truth;
  /// The same problem, of the same name, box and truth, shown at a smoothing width >= 0: the wider,
  /// the smoother; 0 is what is judged. Empty where there is no such knob.
  std::function<Problem(double width)> smoothed;
  /// The best true objective of a feasible point, where it is known, a point that attains it, and
  /// how it was found.
  std::optional<double> best_known;
  std::optional<Vector> best_point;
  std::string provenance;
  /// Whether the problem is defined on all of R^n and best_point, which is then known, is best
  /// there too, so that its instances may be turned about it.
  bool rotates = false;
  /// Empty where instances draw their start. Else the start is part of the problem: instance k
  /// begins at its own image of start_scales[(k - 1) % size] times the start.
  std::vector<double> start_scales = {};

  Eigen::Index dimension() const { return lower.size(); }
};

/// What a point is truly worth: by the problem's truth, or by what it shows where that is the
/// truth.
Truth truth_at(const Problem& problem, const Vector& x);

/// Values taken at their word, of which so many constraints are equalities.
Truth truth_of(const Values& values, Eigen::Index equalities = 0);

/// Whether `a` is strictly better than `b`: less violated, or equally so and lower.
bool better(const Truth& a, const Truth& b);

}  // namespace ricochet
