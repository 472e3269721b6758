#pragma once

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/check/reference_integrators/forces.h"

// NOTE: plain C++17, like forces.h.
namespace ricochet::carrier_track::inline reference_integrators {

/// The force of two compliant walls divided by the mass [m/s^2], as a function of the state: the
/// laws of contact_law.h, without events.
struct WallForce {
  struct Slopes {
    double by_position;  ///< [1/s^2]
    double by_velocity;  ///< [1/s]
  };

  double lower = 0, upper = 0;                  ///< [m], the walls; upper may be infinite
  double stiffness = 0;                         ///< K/m
  double exponent = 1;                          ///< n
  bool viscous = false;                         ///< Kelvin-Voigt
  double lower_damping = 0, upper_damping = 0;  ///< D, or C/m [1/s] if viscous
  double speed = 1;                             ///< [m/s], v0 of the law

  /// Penetration [m], <= 0 between the walls.
  double depth(double position) const { return std::max(lower - position, position - upper); }

  double operator()(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return 0;
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) return outward * std::max(0.0, stiffness * d + damping(outward) * rate);
    return outward * spring(d) * (1 + damping(outward) / speed * rate);
  }

  Slopes slopes(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return {0, 0};
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) {
      const bool presses = stiffness * d + damping(outward) * rate > 0;
      return presses ? Slopes{-stiffness, -damping(outward)} : Slopes{0, 0};
    }
    const double factor = damping(outward) / speed;
    return {-exponent * spring(d) / d * (1 + factor * rate), -factor * spring(d)};
  }

 private:
  double damping(int outward) const { return outward > 0 ? lower_damping : upper_damping; }

  double spring(double d) const {
    if (exponent == 1.5) return stiffness * d * std::sqrt(d);
    return exponent == 1 ? stiffness * d : stiffness * std::pow(d, exponent);
  }
};

/// The walls of a valid scene with compliant walls; `speed` is its contact_speed, or 1 m/s.
WallForce wall_force_of(const BasicScene<double>& scene);

}  // namespace ricochet::carrier_track::inline reference_integrators
