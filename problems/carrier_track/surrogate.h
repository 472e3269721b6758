#pragma once

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// Smoothing width where nobody asks for another: an impact counts half at the limit, 0.9 at 1.73
/// times its speed.
inline constexpr double default_width = 0.25;

struct Slope {
  double value;
  double slope;  ///< per rad/s
};

/// The surrogate of a valid scene, width > 0, and its exact derivative with respect to omega.
Slope surrogate_slope(const Scene& scene, double width);

}  // namespace ricochet::carrier_track
