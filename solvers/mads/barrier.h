#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "src/core/problem.h"

namespace ricochet {

/// A point of the unit box and what it is worth.
struct Trial {
  Vector u;
  double objective = 0;
  double violation = 0;  ///< >= 0, see violation_of
};

/// The sum of the squares of what the constraints are broken by; 0 where they hold.
double violation_of(const Values& values, Eigen::Index equalities);

/// What a trial, or an iteration, brought on.
enum class Progress {
  none,
  improving,  ///< less violated than the infeasible incumbent, but of a higher objective
  dominating  ///< an incumbent is beaten: less violated or lower, and neither more so
};

/// The progressive barrier of Audet and Dennis, SIAM J. Optim. 20 (2009) 445-472, doi
/// 10.1137/070692662: remembers the best feasible point, and of the infeasible ones the lowest
/// whose violation is within a limit that falls as points of less violation are found. Two points
/// are searched around, from both sides of the constraints.
class Barrier {
 public:
  /// Judges a trial by the incumbents. One that is not a number is none. A feasible one that ties
  /// with the best is no progress, but takes its place.
  Progress add(const Trial& trial);

  /// Ends an iteration that made this progress: the best of the trials are the incumbents now.
  void settle(Progress progress);

  const std::optional<Trial>& feasible() const { return feasible_; }
  const std::optional<Trial>& infeasible() const { return infeasible_; }
  double limit() const { return limit_; }

 private:
  Progress add_feasible(const Trial& trial);
  Progress add_infeasible(const Trial& trial);

  std::optional<Trial> feasible_, infeasible_;
  std::optional<Trial> next_feasible_;
  std::vector<Trial> undominated_;  // infeasible, within the limit
  double limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace ricochet
