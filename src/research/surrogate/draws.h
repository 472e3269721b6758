#pragma once

#include "src/core/random.h"

namespace ricochet::studies::surrogate {

/// Evenly in [a, b), from the generator's bits alone: the same everywhere.
inline double within(Random& random, double a, double b) {
  return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace ricochet::studies::surrogate
