#pragma once

#include <algorithm>
#include <cmath>

namespace ricochet::studies::variants {

/// The restitution of viscoelastic spheres, which decreases with the fifth root of the approach
/// speed [m/s] (Kuwabara and Kono 1987, doi:10.1143/JJAP.26.1230): 1 at speed 0, the given one at
/// `reference` [m/s], and 0 where the law would be negative.
inline double speed_restitution(double restitution, double speed, double reference) {
  return std::clamp(1 - (1 - restitution) * std::pow(speed / reference, 0.2), 0.0, 1.0);
}

}  // namespace ricochet::studies::variants
