#pragma once

#include <cstddef>
#include <cstdint>

#include "ricochet/random.h"

namespace ricochet::fireworks {

/// Uniform in [0, 1), in steps of 2^-53. Like uniform(), in a third of the time: random draws are
/// most of the cost of a spark.
inline double share(Random& random) {
  return static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * 0x1p-53;
}

/// Uniform in [-1, 1).
inline double two_sided(Random& random) {
  return 2 * share(random) - 1;
}

/// One of 0, ..., count - 1; count >= 1.
inline std::size_t one_of(std::size_t count, Random& random) {
  return static_cast<std::size_t>(share(random) * static_cast<double>(count));
}

/// True with probability 1/2.
inline bool toss(Random& random) {
  return (random() >> 63) != 0;
}

}  // namespace ricochet::fireworks
