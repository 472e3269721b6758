#pragma once

#include <functional>
#include <optional>

#include "problems/carrier_track/models/observer.h"

namespace ricochet::studies::variants {

/// An additional force along x, constant on each interval.
struct HeldForce {
  double interval;                              ///< [s], > 0
  std::function<double(std::size_t k)> height;  ///< [N], of the k-th interval from 0 on
};

/// Friction with the force along y as the normal force: `share` of the magnitude of the force along
/// y of equation (22), including the projected centrifugal force, instead of the scene's constant.
struct Press {
  double share;  ///< >= 0
  double pull;   ///< [N], T_1 sin phi
};

/// Changes of a variant to the motion of a scene. With nothing set it is the motion of ImpactModel,
/// to the last bit. Recording is up to the observer.
struct MotionChange {
  std::optional<HeldForce> further_force = {};
  std::optional<Press> press = {};
  /// Restitution in [0, 1] of an impact from its approach speed [m/s] and the scene's restitution;
  /// empty: the scene's.
  std::function<double(double speed, double restitution)> restitution = {};
};

/// Also receives every local minimum of x [m], as Observer receives the maxima.
struct VariantObserver : carrier_track::Observer {
  void valley(double /*time*/, double /*position*/) {}
};

}  // namespace ricochet::studies::variants
