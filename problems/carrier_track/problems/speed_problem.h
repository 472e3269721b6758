#pragma once

#include <span>
#include <string>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/machine.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "src/core/problem.h"

namespace ricochet::carrier_track::inline questions {

/// -x[0]: the faster, the better.
struct Slowness {
  static constexpr int jet_size = 1;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return -x[0];
  }
};

/// [rad/s] short of the fastest speed that still counts as solved.
inline constexpr double speed_tolerance = 0.01;

/// [rad/s] that a collision too many costs: no gain of speed in the box outweighs half a collision.
inline constexpr double speed_penalty = 2 * fastest_speed;

/// A problem over the speed alone, still without an objective, "<family>-<id>".
Problem speed_problem(const std::string& family, const Machine& machine, std::string source);

}  // namespace ricochet::carrier_track::inline questions
