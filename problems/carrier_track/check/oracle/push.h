#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// Equation (31) without contact and friction, divided by the mass, in long double: a steady
/// acceleration and two waves, amplitude cos(frequency t + phase), of the driver plate and the
/// disturbance.
struct Push {
  using From = class PushFrom;

  struct Wave {
    long double amplitude = 0;  ///< [m/s^2]
    long double frequency = 1;  ///< [rad/s], > 0
    long double phase = 0;      ///< [rad] at time 0
  };

  /// Throws std::invalid_argument for a scene whose speed is a profile.
  explicit Push(const Scene& scene);

  /// Sum of |amplitude| frequency^power [m/s^(2 + power)]: the scale of rounding errors.
  long double size(int power) const;

  /// Bound on that derivative of the waves [m/s^(2 + power)] up to a time [s]. It never exceeds
  /// size(power) and is far smaller for two waves that almost cancel.
  long double bound(int power, long double until) const;

  /// Bound on the acceleration [m/s^2].
  long double strength() const { return std::abs(steady) + size(0); }

  /// Rounding error of the acceleration (power 0) or the jerk (1) up to a time [s]. That of an
  /// angle grows with the angle.
  long double noise(int power, long double until) const;

  /// [s], a quarter of a radian of the fastest wave; infinite without waves.
  long double piece() const;

  /// Until when PushFrom tells the motion from a time on, and until when the force is smooth.
  static constexpr long double known_until(long double /*time*/) {
    return std::numeric_limits<long double>::infinity();
  }
  static constexpr long double smooth_until(long double time) { return known_until(time); }

  long double steady = 0;  ///< [m/s^2]
  std::array<Wave, 2> waves;
};

/// The state of a body some time after it starts from rest under a push alone.
struct Pushed {
  long double distance;      ///< [m]
  long double speed;         ///< [m/s]
  long double acceleration;  ///< [m/s^2]
  long double jerk;          ///< [m/s^3]
  long double snap;          ///< [m/s^4]
};

/// A push from a start time on.
class PushFrom {
 public:
  PushFrom(const Push& push, long double start);

  /// In closed form, after `elapsed` >= 0 [s]. Differences of sines and cosines are written as
  /// products, so that the shortest flight keeps all its digits.
  Pushed after(long double elapsed) const;

 private:
  struct Angle {
    long double sine, cosine;  // of the wave's angle at the start
  };
  const Push& push_;
  std::array<Angle, 2> angle_;
};

}  // namespace ricochet::carrier_track::inline oracle
