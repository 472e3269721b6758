#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "src/core/vector.h"

namespace ricochet {

/// Objective and constraints at one point; a point is feasible where every constraint is <= 0.
struct Values {
  double objective = 0;
  Vector constraints;  ///< length Problem::constraints
};

struct Derivatives {
  Values values;
  Vector gradient;  ///< of the objective, length n
  Matrix jacobian;  ///< of the constraints, Problem::constraints x n
};

/// The objective as a solver for least squares sees it: half the sum of the squares of `values`.
struct Residuals {
  Vector values;    ///< at least one, as many at every point
  Matrix jacobian;  ///< residuals x n
};

/// What a point is really worth, whatever the solver was shown.
struct Truth {
  double objective = 0;
  double violation = 0;  ///< largest true constraint value, 0 where feasible
};

/// A minimisation problem within a box. Immutable once built; runs own all state. The functions may
/// be called from several threads at once. They throw what went wrong; the evaluator catches it.
struct Problem {
  std::string name;    ///< e.g. "count-C1"
  std::string source;  ///< what it is, and where it comes from
  int instance = 0;    ///< 0 is the problem as stated; see instance.h
  Vector lower, upper, start;
  Eigen::Index constraints = 0;

  /// What a solver sees.
  std::function<Values(const Vector&)> evaluate;
  /// Values and first derivatives in one call; empty where the problem has none.
  std::function<Derivatives(const Vector&)> differentiate;
  /// Residuals and first derivatives in one call; empty where the problem is no sum of squares.
  /// Theirs may be a smooth stand-in for the objective.
  std::function<Residuals(const Vector&)> residuals;
  /// What the suite judges by; empty where `evaluate` is the truth.
  std::function<Truth(const Vector&)> truth;
  /// The best true objective of a feasible point, where it is known.
  std::optional<double> best_known;

  Eigen::Index dimension() const { return lower.size(); }
};

/// Values taken at their word.
Truth truth_of(const Values& values);

/// Whether `a` is strictly better than `b`: less violated, or equally so and lower.
bool better(const Truth& a, const Truth& b);

}  // namespace ricochet
