#pragma once

#include "src/benchmark/comparison/group.h"

namespace ricochet::studies::comparison {

/// Does the order hold on problems held out? For every group, with the largest budget: how well the
/// order of the ranked entries on half of the problems predicts that on the other half. `measured`
/// is false for a group with too few problems or entries.
report::Json held_out_data(const Comparison& comparison, const std::vector<Group>& groups);

}  // namespace ricochet::studies::comparison
