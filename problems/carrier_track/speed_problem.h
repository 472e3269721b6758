#pragma once

#include <span>
#include <string>

#include "problems/carrier_track/machine.h"
#include "problems/carrier_track/speed_range.h"
#include "problems/carrier_track/surrogate.h"
#include "src/core/problem.h"

namespace ricochet::carrier_track {

/// -x[0]: the faster, the better.
struct Slowness {
  static constexpr int room = 1;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return -x[0];
  }
};

/// A problem over the speed alone, still without an objective, "<family>-<id>".
Problem speed_problem(const std::string& family, const Machine& machine, std::string source);

}  // namespace ricochet::carrier_track
