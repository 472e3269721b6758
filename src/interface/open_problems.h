#pragma once

#include <ricochet/ricochet.h>

#include "src/interface/open_handles.h"
#include "src/interface/opened_problem.h"

namespace ricochet::interface {

using OpenProblems = OpenHandles<ricochet_problem, OpenedProblem>;

/// All open problems. Never destroyed: a program may close its problems while it ends.
OpenProblems& open_problems();

}  // namespace ricochet::interface
