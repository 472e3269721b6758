#pragma once

#include "ricochet/solver.h"

namespace ricochet {

/// A homotopy method: the solver solves the problem with a large smoothing parameter, then with
/// smaller ones, each from the previous result, until the problem is close to the true one. For
/// problems with a smoothing parameter. Named "continuation-" and the solver's name.
Solver continuation(Solver solver);

/// The capabilities of the continued solver, but without equalities; gradients and smoothing are
/// required.
Capabilities continuation_capabilities(const Capabilities& of);

}  // namespace ricochet
