#pragma once

#include <span>
#include <string>

#include "problems/carrier_track/collisions.h"
#include "problems/carrier_track/machine.h"
#include "problems/carrier_track/speed_range.h"
#include "src/core/problem.h"

namespace ricochet::carrier_track {

/// The objective of collisions.h at a constant speed, x[0] [rad/s]; a Function of derivatives.h.
struct ObjectiveAtSpeed {
  Scene scene;
  double width;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> at = at_speed(lifted<Scalar>(scene), x[0]);
    auto watching = watch.of(at);
    return objective(at, width, watching);
  }
};

/// -x[0]: the faster, the better.
struct Slowness {
  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return -x[0];
  }
};

/// A problem over the speed alone, still without an objective, "<family>-<id>".
Problem speed_problem(const std::string& family, const Machine& machine, std::string source);

}  // namespace ricochet::carrier_track
