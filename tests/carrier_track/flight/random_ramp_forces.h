#pragma once

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/forces.h"

namespace ricochet::carrier_track {

/// Forces that use every term of RampForces.
inline RampForces<double> random_ramp_forces(RandomScenes& draws) {
  const auto within = [&](double a, double b) { return draws.within(a, b); };
  return {{within(-1, 1), within(-0.1, 0.1), within(-1, 1), within(-0.1, 0.1), within(-0.1, 0.1),
           within(-1, 1), within(-0.1, 0.1), within(-0.1, 0.1)},
          {within(-1, 1), within(-1, 1), draws.log_within(0.3, 30)},
          within(-4, 4),
          draws.log_within(0.3, 20),
          draws.chance(0.2) ? 0.0 : within(-20, 20)};
}

}  // namespace ricochet::carrier_track
