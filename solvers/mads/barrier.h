#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "ricochet/problem.h"

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
  /// Compares a trial with the incumbents. A trial that is not a number is ignored. A feasible
  /// trial that ties with the best is no progress, but replaces it.
  Progress add(const Trial& trial);

  /// Ends an iteration with this progress: the best trials become the incumbents.
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
