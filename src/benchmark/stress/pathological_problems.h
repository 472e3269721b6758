#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "src/benchmark/experiment/campaign/worker.h"

namespace ricochet::studies::stress {

/// A failure that happens in practice, as a problem.
struct PathologicalProblem {
  std::string what;  ///< e.g. "no number in a corner"
  Problem problem;   ///< with derivatives and residuals wherever they make sense
  Budget budget = {400};
  Limits limits = {20, 500};
};

/// All of them.
std::vector<PathologicalProblem> pathological_problems();

}  // namespace ricochet::studies::stress
