#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

namespace ricochet {

/// The start is moved by a vector of random direction, uniform on the sphere, with length 1e-3
/// after scaling every side of the box to 1. A coordinate that would leave the box is moved the
/// other way, so that a start on the edge is moved too. If the problem has no start of its own, it
/// gets this one: every run begins near it, not anywhere in the box; only restarts of the solver
/// begin elsewhere.
Perturbation perturbed_start();

}  // namespace ricochet
