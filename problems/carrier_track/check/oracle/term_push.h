#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/check/oracle/push.h"

namespace ricochet::carrier_track::inline oracle {

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
