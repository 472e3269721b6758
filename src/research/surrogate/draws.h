#pragma once

#include "ricochet/random.h"

namespace ricochet::studies::surrogate {

/// Uniform in [a, b), from the generator's bits only: the same on every platform.
inline double within(Random& random, double a, double b) {
  return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace ricochet::studies::surrogate
