#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// A solver led by the hand: it solves the problem at a wide smoothing width, then at narrower ones
/// from where it came to, until the problem is next to the one that counts. For problems that have
/// the knob. Named "continuation-" and the solver's name.
Solver continuation(Solver solver);

}  // namespace ricochet
