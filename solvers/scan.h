#pragma once

#include <cstdint>

#include "ricochet/solver.h"

namespace ricochet {

/// "scan": for one dimension, an exhaustive scan that does not need to know its budget: both ends
/// of the box, then the van der Corput points in base 2, each halving a widest gap. After 2^k + 1
/// evaluations the points are an even grid. It ignores the start and does not compare points
/// itself, so it takes any constraints.
Solver scan();

/// The k-th van der Corput number in base 2, in [0, 1): the binary digits of k mirrored at the
/// binary point. k = 0, 1, 2, 3, 4 give 0, 1/2, 1/4, 3/4, 1/8.
/// Source: van der Corput, Proc. Akad. Wet. Amsterdam 38 (1935) 813-821.
double van_der_corput(std::uint64_t k);

}  // namespace ricochet
