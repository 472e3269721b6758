#pragma once

#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

/// The plan's top-speed questions as they are asked of other machines: of each machine so many that
/// are drawn around it, with the best value that an exhaustive scan finds. One instance of each
/// question, with the plan's largest budget. No question where the plan has no top speed.
ContestPlan drawn_plan(const ContestPlan& plan);

}  // namespace ricochet::studies::contest
