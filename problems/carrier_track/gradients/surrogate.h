#pragma once

#include <span>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/scene/lifted.h"

namespace ricochet::carrier_track::inline gradients {

/// The objective of collisions.h at a constant speed, x[0] [rad/s]; a Function of derivatives.h.
struct ObjectiveAtSpeed {
  static constexpr int jet_size = 1;

  Scene scene;
  double smoothing;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> at = at_speed(lifted<Scalar>(scene), x[0]);
    auto watching = watch.of(at);
    return objective(at, smoothing, watching);
  }
};

struct Slope {
  double value;
  double slope;  ///< per rad/s
  Trust trust;   ///< in a box of the given width
};

/// The surrogate of a valid scene, smoothing parameter > 0, and its exact derivative with respect
/// to omega, which may vary over a range [rad/s].
Slope surrogate_slope(const Scene& scene, double smoothing, double range = 18.0);

}  // namespace ricochet::carrier_track::inline gradients
