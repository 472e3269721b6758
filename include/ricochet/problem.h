#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/formulation.h"

namespace ricochet {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// Objective and constraints at one point. A point is feasible if the equalities, which come first,
/// are 0 and every other constraint is <= 0, all to within constraint_tolerance.
struct Values {
  double objective = 0;
  Vector constraints;  ///< length Problem::constraints
};

/// Why an exact gradient may mislead.
enum class GradientDoubt {
  none,       ///< no reason known
  flat,       ///< zero, or so small that the function hardly changes across the box
  kink,       ///< the function has a corner, or an infinite slope, next to the point
  sensitive,  ///< rounding of the point changes the value by a loss of digits
};

/// How far a gradient can be trusted. A problem without this knowledge keeps the default.
struct Trust {
  /// Distance from the point up to which the function stays smooth, to first order, in box widths.
  double reach = std::numeric_limits<double>::infinity();
  GradientDoubt doubt = GradientDoubt::none;
};

struct Derivatives {
  Values values;
  Vector gradient;  ///< of the objective, length n
  Matrix jacobian;  ///< of the constraints, Problem::constraints x n
  Trust trust = {};
};

/// The objective as a least-squares solver sees it: half the sum of the squares of `values`.
struct Residuals {
  Vector values;    ///< at least one, the same number at every point
  Matrix jacobian;  ///< residuals x n
};

/// A constraint holds if it is violated by at most this: a solver that converges to a limit ends on
/// either side of it. The score, and every solver that takes a tolerance, use this one; see
/// docs/benchmark-method.md.
inline constexpr double constraint_tolerance = 1e-6;

/// The violation of a constraint, absolute for an equality: 0 where it holds to within
/// constraint_tolerance, NaN where the constraint is NaN.
double violation_of(double constraint, bool is_equality);

/// The true objective and the true violation of a point, whatever the formulation.
struct TrueValues {
  double objective = 0;
  double violation = 0;  ///< largest violation of a constraint; 0 if feasible
};

/// A range of a coordinate.
struct CoordinateRange {
  double from, to;
};

/// Name and unit of a coordinate.
struct Variable {
  std::string name;  ///< e.g. "omega"
  std::string unit;  ///< empty if it has none
};

/// A minimisation problem of n variables within a box: what is benchmarked. Immutable once built;
/// runs own all state. The functions may be called from several threads at once. They throw what
/// went wrong; the evaluator catches it. A solver does not see a Problem but an Evaluator.
struct Problem {
  std::string name;        ///< e.g. "count-C1"
  std::string source;      ///< short description and origin
  std::string unit = {};   ///< of the objective; empty if it has none
  bool maximises = false;  ///< the objective is the negative of what a user wants to be large
  bool jumps = false;      ///< objective or constraints jump, as whole numbers do
  int instance = 0;        ///< 0 is the problem as stated; see instance.h
  std::vector<Variable> variables;  ///< n, or empty if they have no names
  Vector lower, upper, start;       ///< length n, lower <= start <= upper, finite
  Eigen::Index constraints = 0;
  Eigen::Index equalities = 0;  ///< this many of the constraints, the first ones, must be 0

  /// Objective and constraints at a point of length n.
  std::function<Values(const Vector&)> evaluate;
  /// Values and first derivatives in one call; empty if the problem has none.
  std::function<Derivatives(const Vector&)> differentiate;
  /// Second derivatives, n x n and symmetric, of the Lagrangian: objective_factor times the
  /// objective, plus every constraint times its multiplier, of which there are
  /// Problem::constraints. Empty if the problem has none.
  std::function<Matrix(const Vector& x, double objective_factor, const Vector& multipliers)>
      lagrangian_hessian;
  /// Residuals and first derivatives in one call; empty if the problem is no sum of squares. Their
  /// sum of squares may be a smooth approximation of the objective.
  std::function<Residuals(const Vector&)> residuals;
  /// The same residuals where they cost less without derivatives; empty: `residuals` has them.
  std::function<Vector(const Vector&)> residual_values = {};
  /// The true objective and violation, which score a run; empty if `evaluate` returns them.
  std::function<TrueValues(const Vector&)> true_values;
  /// The same problem, with the same name, box and true objective, smoothed with a parameter >= 0:
  /// the larger, the smoother; 0 means no smoothing. Empty if the problem cannot be smoothed.
  std::function<Problem(double smoothing)> smoothed;
  /// The best true objective of a feasible point, a point that attains it, and how they were found;
  /// empty if not known.
  std::optional<double> best_known;
  std::optional<Vector> best_point;
  std::string provenance;
  /// No feasible point has a lower true objective, which is proven; empty if nothing is.
  std::optional<double> lower_bound = {};
  /// For a problem of one variable: the ranges of x in which a point that is better than this true
  /// objective is not excluded, by an argument that covers the whole box. Empty if there is none.
  std::function<std::vector<CoordinateRange>(double objective)> not_excluded = {};
  /// True if the problem is defined on all of R^n and best_point, which is then known, is best
  /// there too: instances may then be rotated about it.
  bool rotates = false;
  /// True if the problem goes on beyond an end of its box as its mirror image, without a corner
  /// there: instances may then move a best point away from that end.
  bool mirrors = false;
  /// Empty if instances draw their start. Otherwise the start is part of the problem: instance k
  /// starts at its own image of start_scales[(k - 1) % size] times the start.
  std::vector<double> start_scales = {};

  /// Problems of one cluster are alike, such as one function at several sizes or starts, or one
  /// machine: statistics draw clusters. Empty: it is alone in one of its name.
  std::string cluster = {};
  std::string machine = {};  ///< whose scene it is, e.g. "C1"; empty where it is of none
  double smoothing = 0;      ///< smoothing parameter of the formulation "surrogate"
  /// Optimality gap that still counts as solved: >= 0, and no less than what constraint_tolerance
  /// is worth, since a feasible point may be better than best_known by that.
  double tolerance = 1e-6;
  double penalty_weight = 1;  ///< > 0: the best point stays best where constraints are penalised
  double scan_step = 1e-3;    ///< of an exhaustive scan of the box, if n = 1
  double cost = 1;            ///< approximate number of simulations per evaluation
  /// Measured cost of a gradient beside the value [evaluations]; n if empty.
  std::optional<std::int64_t> gradient_cost = {};
  /// An evaluation may throw, hang or end the process; true_values_at() does not. Patterns choose
  /// such a problem only if they begin with its family's name.
  bool hazardous = false;
  /// Nothing of the suite was chosen by runs on it. Patterns choose it by its family's name alone.
  bool held_out = false;
  /// A run is killed after this time [s] if its limit is not shorter; empty: by its limit only.
  std::optional<double> longest_run = {};
  /// What varies from machine to machine, by name, e.g. "restitution".
  std::map<std::string, double> factors = {};

  Eigen::Index dimension() const { return lower.size(); }

  /// Its formulations: original, then smoothed with its usual smoothing parameter and with these;
  /// if it has constraints, each is followed by its penalised variant.
  std::vector<Formulation> formulations(const std::vector<double>& smoothings = {}) const;

  /// The problem in this formulation, with any smoothing parameter. Throws std::invalid_argument
  /// for a formulation that it does not have.
  Problem formulated(const Formulation& formulation) const;

  /// "count" and "surrogate" if the problem can be smoothed, with the smoothing parameter if it is
  /// not the usual one, else "original"; "penalised-count", "penalised" and so on.
  std::string name_of(const Formulation& formulation) const;

  /// The one of formulations() with this name; the first one for an empty name. Throws InputError,
  /// with similar names, for any other.
  Formulation formulation_named(const std::string& name) const;
};

/// The true objective and violation at x, of length n. Throws what the problem throws.
TrueValues true_values_at(const Problem& problem, const Vector& x);

/// The same, computed from true values with this number of equalities.
TrueValues true_values_of(const Values& values, Eigen::Index equalities = 0);

/// Returns true if `a` is strictly better than `b`: its violation is smaller, or equal with a
/// lower objective.
bool better(const TrueValues& a, const TrueValues& b);

// @file
// The families of problems.

/// Problems of one kind. src/analysis/comparison/families.toml describes them.
struct Family {
  std::string name;  ///< what the names of its problems begin with, e.g. "top-speed"
  std::vector<Problem> problems;
};

/// Every family of problems: those of the paper's cases and of the literature. With a scene file,
/// those of its machine instead; throws InputError if the file is invalid.
std::vector<Family> all_families(const std::string& scene_file = "");

/// The problems of all families, in order.
std::vector<Problem> every_problem(const std::vector<Family>& families);

}  // namespace ricochet
