#pragma once

#include "ricochet/solver.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// How every solver behaves on pathological problems: values missing in a corner, an objective that
/// throws or sleeps, no feasible point, and so on. The runs are made in other processes.
Study stress_study(const std::vector<Solver>& solvers);

}  // namespace ricochet::studies
