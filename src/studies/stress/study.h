#pragma once

#include "src/core/solver.h"
#include "src/studies/study.h"

namespace ricochet::studies {

/// What every solver does where a problem is ill: with no number in a corner, with a throwing or a
/// sleeping objective, without a feasible point, and so on. Each run in a process of its own.
Study stress_study(const std::vector<Solver>& solvers);

}  // namespace ricochet::studies
