#pragma once

#include <cstdint>
#include <optional>

#include "ricochet/problem.h"
#include "ricochet/run.h"

namespace ricochet {

/// The score of a run: of its best evaluated point and of the point that it returned, which may be
/// worse.
struct Verdict {
  bool feasible = false;                 ///< a feasible point was evaluated
  std::optional<double> objective;       ///< best true objective among feasible points
  std::optional<double> optimality_gap;  ///< objective - best known, if both exist
  bool solved = false;                   ///< optimality gap <= tolerance
  std::optional<std::int64_t> evaluations_to_solve;
  std::optional<double> seconds_to_solve;
  /// The optimality gap of the returned point; empty if it is infeasible or there is none.
  std::optional<double> returned_optimality_gap;
  bool returned_solved = false;
};

/// `tolerance`: the largest optimality gap, >= 0, that counts as solved. Without a best known value
/// a run has no optimality gap and is not solved.
Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance);
Verdict judge(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet
