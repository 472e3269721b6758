#pragma once

#include <cstdint>
#include <optional>

#include "src/core/problem.h"
#include "src/core/run.h"

namespace ricochet {

/// What a point is truly worth: by the problem's truth, or by what it shows where that is the
/// truth.
Truth truth_at(const Problem& problem, const Vector& x);

/// What the suite says of a run, from its trace alone.
struct Verdict {
  bool feasible = false;            ///< a truly feasible point was found
  std::optional<double> objective;  ///< best true objective among feasible points
  std::optional<double> regret;     ///< objective - best known, where both exist
  bool solved = false;              ///< regret <= tolerance
  std::optional<std::int64_t> evaluations_to_solve;
  std::optional<double> seconds_to_solve;
};

/// `tolerance` >= 0 is the regret that still counts as solved.
Verdict judge(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet
