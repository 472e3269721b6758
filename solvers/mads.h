#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// A point of the unit box with its objective and violation.
struct Trial {
  Vector u;
  double objective = 0;
  double violation = 0;  ///< >= 0, see violation_of
};

/// The sum of squares of the constraint violations; 0 where all constraints hold.
double violation_of(const Values& values, Eigen::Index equalities);

/// The result of a trial or of an iteration.
enum class Progress {
  none,
  improving,  ///< less violated than the infeasible incumbent, but with a higher objective
  dominating  ///< better than an incumbent: less violated or lower, and not worse in either
};

/// The progressive barrier of Audet and Dennis, SIAM J. Optim. 20 (2009) 445-472, doi
/// 10.1137/070692662. It remembers the best feasible point, and the infeasible point of lowest
/// objective whose violation is within a limit; the limit falls as points with less violation are
/// found. The search polls around both points.
class Barrier {
 public:
  /// `accepts_ties`: a feasible trial that ties with the best replaces it, though it is no
  /// progress.
  explicit Barrier(bool accepts_ties) : accepts_ties_(accepts_ties) {}

  /// Compares a trial with the incumbents. A trial that is not a number is ignored.
  Progress add(const Trial& trial);

  /// Ends an iteration with this progress: the best trials become the incumbents.
  void settle(Progress progress);

  const std::optional<Trial>& feasible() const { return feasible_; }
  const std::optional<Trial>& infeasible() const { return infeasible_; }
  double limit() const { return limit_; }

 private:
  Progress add_feasible(const Trial& trial);
  Progress add_infeasible(const Trial& trial);

  bool accepts_ties_;
  std::optional<Trial> feasible_, infeasible_;
  std::optional<Trial> next_feasible_;
  std::vector<Trial> undominated_;  // infeasible, within the limit
  double limit_ = std::numeric_limits<double>::infinity();
};

/// "mads": mesh adaptive direct search (Audet and Dennis, SIAM J. Optim. 17 (2006) 188-217, doi
/// 10.1137/040603371) in the unit cube. It needs neither slopes nor continuity, and handles
/// constraints by a progressive barrier; see mads.h. An iteration first looks further along the
/// step of the last success, up to four times its length. It then polls around the incumbents in
/// the n + 1 directions of OrthoMADS that point most along this step; see mads.h. The
/// first point that beats an incumbent ends the iteration, and the mesh becomes coarser; if there
/// is none, the mesh is refined. Points outside the box are moved to its faces.
///
/// If there is a feasible incumbent and an infeasible one with a lower objective, it polls in all
/// directions around the feasible one, and in two opposite directions around the other; the other
/// way round if the infeasible one is lower by more than the trigger of the progressive barrier,
/// 0.1. The first poll is at 0.1 of the box. These are the settings of NOMAD 3 (Le Digabel, ACM
/// Trans. Math. Softw. 37 (2011) 44; doi 10.1145/1916461.1916468). Ends when polls are at 1e-8 of
/// the box; it can then be restarted elsewhere.
///
/// "mads-tuned": with what did best on this suite. The first poll is at a quarter of the box, and
/// the feasible incumbent always comes first. A feasible point that ties with its incumbent is no
/// success, but replaces it, so that the search moves along a plateau. Ends when polls are at 1e-4
/// of the box.
Solver mads(Settings settings);

/// Options: "finest_mesh", as a share of the box; "mesh_index", the initial index, see Mesh; and
/// "further", how far to look along the last success, in lengths of its step (0: not at all).
std::vector<AdjustableSolver> adjustable_mads();

/// Mesh size and distance of a poll from its centre, as shares of a scale: 4^-index and 2^-index,
/// so that a finer mesh offers more directions; 1 and 2^-index if the index is negative (Abramson,
/// Audet, Dennis and Le Digabel 2009, doi 10.1137/080716980, table 3.1).
class Mesh {
 public:
  /// `scale`: of the box. The index does not fall below `coarsest` when a mesh is made coarser.
  Mesh(int index, int coarsest, double scale) : index_(index), coarsest_(coarsest), scale_(scale) {}

  int index() const { return index_; }
  double spacing() const { return scale_ * std::ldexp(1.0, -2 * std::max(index_, 0)); }

  void refine() { ++index_; }
  void coarsen() { index_ = std::min(index_, std::max(index_ - 1, coarsest_)); }

 private:
  int index_, coarsest_;
  double scale_;
};

// The directions of OrthoMADS: Abramson, Audet, Dennis and Le Digabel, SIAM J. Optim. 20 (2009)
// 948-966, doi 10.1137/080716980.

/// An orthogonal n x n matrix of integers: the Householder matrix |q|^2 I - 2 q q^T, where q is the
/// longest integer vector along `direction` (length n, not 0) with a norm of at most 2^(index / 2).
/// Its columns have the norm |q|^2, at most 2^index. index >= 0.
Matrix poll_basis(const Vector& direction, int index);

/// n + 1 directions that span the space positively. The first n are the columns of `basis`, each
/// with the sign that points along `leading`, sorted by how much they do; the last is the opposite
/// of their sum (Audet, Ianni, Le Digabel and Tribes, SIAM J. Optim. 24 (2014) 621-642, doi
/// 10.1137/120895056, without their quadratic models).
std::vector<Vector> poll_directions(const Matrix& basis, const Vector& leading);

}  // namespace ricochet
