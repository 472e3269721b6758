#pragma once

#include "src/core/solver.h"
#include "src/studies/study.h"

namespace ricochet::studies {

/// What every solver does where a problem is ill: with no number in a corner, with a throwing or a
/// sleeping objective, without a feasible point, and so on. The runs are made in other processes.
Study stress_study(const std::vector<Solver>& solvers);

}  // namespace ricochet::studies
