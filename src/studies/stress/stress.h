#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/experiment/worker.h"
#include "src/report/site/study.h"

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

namespace ricochet::studies {

/// How every solver behaves on pathological problems: values missing in a corner, an objective that
/// throws or sleeps, no feasible point, and so on. The runs are made in other processes.
Study stress_study(const std::vector<Solver>& solvers);

}  // namespace ricochet::studies
