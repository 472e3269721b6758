#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// "random-search": the start, then points uniform in the box until the evaluator refuses. The
/// floor: a solver that does no better has learnt nothing. Judges nothing itself, so constraints
/// do not hinder it.
Solver random_search();

}  // namespace ricochet
