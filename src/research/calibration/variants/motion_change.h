#pragma once

#include <functional>
#include <optional>

#include "problems/carrier_track/models/observer.h"

namespace ricochet::studies::trials {

/// A further force along x, held from one multiple of an interval to the next.
struct HeldForce {
  double interval;                              ///< [s], > 0
  std::function<double(std::size_t k)> height;  ///< [N], of the k-th interval from 0 on
};

/// The press of y as the normal force: `share` of the size of the force along y of equation (22),
/// with the projected centrifugal force's part, in place of the scene's constant.
struct Press {
  double share;  ///< >= 0
  double pull;   ///< [N], T_1 sin phi
};

/// What a trial changes about the motion of a scene. With nothing set it is the motion of
/// ImpactModel, to the last bit. What is recorded is the observer's affair.
struct WhatIf {
  std::optional<HeldForce> further_force = {};
  std::optional<Press> press = {};
  /// In [0, 1], of an impact at an approach speed [m/s], from the restitution of the scene; empty:
  /// that itself.
  std::function<double(double speed, double restitution)> restitution = {};
};

/// Is told of every local minimum of x [m] too, as Observer is of the maxima.
struct WhatIfObserver : carrier_track::Observer {
  void valley(double /*time*/, double /*position*/) {}
};

}  // namespace ricochet::studies::trials
