#pragma once

#include <span>
#include <string>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/machine.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/problem.h"

namespace ricochet::carrier_track::inline problems {

/// -x[0]: minimising it maximises the speed.
struct Slowness {
  static constexpr int jet_size = 1;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return -x[0];
  }
};

/// [rad/s] below the fastest quiet speed that still count as solved.
inline constexpr double speed_tolerance = 0.01;

/// [rad/s], penalty for one collision too many: no gain of speed in the box outweighs half a
/// collision.
inline constexpr double speed_penalty = 2 * fastest_speed;

/// A problem of the speed alone, "<family>-<id>", without an objective yet.
Problem speed_problem(const std::string& family, const Machine& machine, std::string source);

}  // namespace ricochet::carrier_track::inline problems
