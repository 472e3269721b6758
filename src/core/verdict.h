#pragma once

#include <cstdint>
#include <optional>

#include "src/core/problem.h"
#include "src/core/run.h"

namespace ricochet {

/// What the suite says of a run: from its trace what was found, which is more than a user gets
/// where the solver hands over another point.
struct Verdict {
  bool feasible = false;            ///< a truly feasible point was found
  std::optional<double> objective;  ///< best true objective among feasible points
  std::optional<double> regret;     ///< objective - best known, where both exist
  bool solved = false;              ///< regret <= tolerance
  std::optional<std::int64_t> evaluations_to_solve;
  std::optional<double> seconds_to_solve;
  /// The same of the point handed over: nothing where it is infeasible or there is none.
  std::optional<double> handed_over_regret;
  bool handed_over_solved = false;
};

/// `tolerance` >= 0 is the regret that still counts as solved. Without a best known value nothing
/// is solved, and nothing has a regret.
Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance);
Verdict judge(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet
