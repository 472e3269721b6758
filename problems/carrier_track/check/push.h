#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// A force (a0 + a1 u + a2 u^2) cos(p0 + p1 u + p2 u^2), u [s] since the start of its piece: exact
/// for a driver plate whose speed changes linearly with time.
struct PushTerm {
  std::array<long double, 3> amplitude;  ///< a0 [N], a1 [N/s], a2 [N/s^2]
  std::array<long double, 3> phase;      ///< p0 [rad], p1 [rad/s], p2 [rad/s^2]
};

/// The sum of terms from a time [s] on, until the next piece, or for ever.
struct PushPiece {
  long double from;
  std::vector<PushTerm> terms;
};

/// Equation (31) without contact and friction, for a valid scene, whose speed may be a profile. It
/// shares no code with the simulation. Terms that are zero as doubles are left out.
std::vector<PushPiece> applied_force(const Scene& scene);

/// The state of a body some time after it starts from rest under a push alone.
struct Pushed {
  long double distance;      ///< [m]
  long double speed;         ///< [m/s]
  long double acceleration;  ///< [m/s^2]
  long double jerk;          ///< [m/s^3]
  long double snap;          ///< [m/s^4]
};

/// An applied force divided by the mass, in 80-bit numbers.
class Push {
 public:
  /// `force`: the first piece begins at 0, each later than the one before. `mass` [kg]. `until`
  /// [s]: the end of the window.
  Push(std::vector<PushPiece> force, long double mass, long double until);

  /// Bound on the derivative of that order, 0 to 3, within the window [m/s^(2 + order)]. Far
  /// smaller than the sum of the amplitudes for waves that almost cancel.
  long double bound(int order) const { return bounds_[static_cast<std::size_t>(order)]; }

  /// Bound on the acceleration, the sum of the amplitudes [m/s^2].
  long double strength() const { return sizes_[0]; }

  /// Rounding error of the acceleration (order 0) or the jerk (1) within the window. That of an
  /// angle grows with the angle.
  long double noise(int order) const;

  /// [s], a quarter of a radian of the fastest term; infinite without one.
  long double piece() const { return piece_; }

  /// Until when PushFrom tells the motion from a time on, and until when the force is smooth [s].
  long double known_until(long double time) const;
  long double smooth_until(long double time) const;

  /// The piece of a time, with terms divided by the mass.
  const PushPiece& at(long double time) const;

 private:
  std::vector<PushPiece> pieces_;
  // Of the derivatives of order 0 to 3: bounds, and sums over the terms, the scale of rounding.
  std::array<long double, 4> bounds_{}, sizes_{};
  long double angle_ = 0;  // bound on the phases [rad]
  long double piece_;
};

/// A push from a start time on, as a power series in the time elapsed, so that the shortest flight
/// keeps all its digits.
class PushFrom {
 public:
  PushFrom(const Push& push, long double start);

  /// After `elapsed` [s], up to Push::known_until(start).
  Pushed after(long double elapsed) const;

 private:
  std::array<long double, 38> series_{};  // of the distance
};

}  // namespace ricochet::carrier_track::inline oracle
