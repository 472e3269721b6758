#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

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

/// An acceleration (a0 + a1 u + a2 u^2) cos(p0 + p1 u + p2 u^2), u [s] since the start of its
/// piece: exact for a driver plate whose speed changes linearly with time.
struct PushTerm {
  std::array<long double, 3> amplitude;  ///< a0 [m/s^2], a1 [m/s^3], a2 [m/s^4]
  std::array<long double, 3> phase;      ///< p0 [rad], p1 [rad/s], p2 [rad/s^2]
};

/// The applied forces divided by the mass, as a sum of terms on each piece of time.
class TermPush {
 public:
  using From = class TermPushFrom;

  struct Piece {
    long double from;  ///< [s]; until the next piece, or for ever
    std::vector<PushTerm> terms;
  };

  /// `pieces`: the first begins at 0, each later than the one before. `until` [s]: the end of the
  /// window.
  TermPush(std::vector<Piece> pieces, long double until);

  /// As in Push. The bounds hold up to the end of the window, whatever the time given.
  long double bound(int power, long double until) const;
  long double strength() const { return sizes_[0]; }
  long double noise(int power, long double until) const;
  long double piece() const { return piece_; }
  long double known_until(long double time) const;
  long double smooth_until(long double time) const;

  /// The piece of a time.
  const Piece& at(long double time) const;

 private:
  std::size_t index_at(long double time) const;

  std::vector<Piece> pieces_;
  std::array<long double, 4> sizes_{};  // bounds on the derivatives of order 0 to 3
  long double angle_ = 0;               // bound on the phases [rad]
  long double piece_;
};

/// A push from a start time on, as a power series in the time elapsed.
class TermPushFrom {
 public:
  TermPushFrom(const TermPush& push, long double start);

  /// After `elapsed` [s], up to TermPush::known_until(start).
  Pushed after(long double elapsed) const;

 private:
  std::array<long double, 36> series_{};  // of the acceleration
};

}  // namespace ricochet::carrier_track::inline oracle
