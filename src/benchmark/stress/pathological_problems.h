#pragma once

#include <string>
#include <vector>

#include "src/campaign/worker.h"
#include "src/core/problem.h"

namespace ricochet::studies::stress {

/// Something that goes wrong in practice, as a problem.
struct IllProblem {
  std::string what;  ///< e.g. "no number in a corner"
  Problem problem;   ///< with derivatives and residuals wherever they make sense
  Budget budget = {400};
  Limits limits = {20, 500};
};

/// All of them.
std::vector<IllProblem> ill_problems();

}  // namespace ricochet::studies::stress
