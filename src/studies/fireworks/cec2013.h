#pragma once

#include "ricochet/problem.h"

namespace ricochet::studies::fireworks {

/// Function 1 to 28 of the competition on real-parameter optimisation at CEC 2013, on [-100,
/// 100]^n, minus its best value, so that the minimum is 0; n is 2, 5, 10, 20, ..., 100. The code is
/// pagmo's, which is not thread-safe: one problem per thread. Throws std::invalid_argument for
/// another number or n.
Problem cec2013(unsigned number, unsigned n);

}  // namespace ricochet::studies::fireworks
