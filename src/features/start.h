#pragma once

#include "src/features/feature.h"

namespace ricochet {

/// The start is moved by a vector of random direction, uniform on the sphere, whose length is 1e-3
/// where every side of the box has length 1. A coordinate that would leave the box is moved the
/// other way, so that a start on the edge is moved, too. Where the start is no part of the problem,
/// it becomes one: every run begins next to it, and not anywhere in the box; only where the solver
/// is started again, that is elsewhere.
Feature perturbed_start();

}  // namespace ricochet
