#pragma once

#include <cstdint>

namespace ricochet::carrier_track::inline models {

enum class Wall { lower, upper };

/// The state in which a simulation ended.
template <class Scalar>
struct End {
  Scalar time;               ///< [s]
  Scalar position;           ///< [m]
  Scalar velocity;           ///< [m/s]
  std::int64_t evaluations;  ///< of the closed-form flight
};

/// What a simulation tells while it runs; observers hide the calls they care for.
struct Observer {
  /// Whether nothing but impacts is of interest, which saves the telling of all else.
  static constexpr bool hears_impacts_alone = false;

  /// Whether stretches are of interest; the same during a simulation. They may be told even so.
  static constexpr bool hears_stretches() { return true; }

  /// An impact at `time` [s] with approach speed [m/s] >= 0; slow ones too, until the body sticks.
  template <class Scalar>
  void impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& /*speed*/) {}

  /// The same on a wall of the second direction, y, of fidelity planar. It does not count.
  template <class Scalar>
  void across_impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& /*speed*/) {}

  /// A local maximum of x [m], first reached at `time` [s]; the ends of the window are none.
  template <class Scalar>
  void peak(const Scalar& /*time*/, const Scalar& /*position*/) {}

  /// At `time` [s] the body, which moved towards the wall `ahead`, has come to a stop at `position`
  /// [m] without touching it.
  template <class Scalar>
  void turn(const Scalar& /*time*/, const Scalar& /*position*/, Wall /*ahead*/) {}

  /// Hops on a wall from `time` [s] on, infinitely many, that are summed and not told one by one.
  template <class Scalar>
  void hops(const Scalar& /*time*/, Wall /*wall*/) {}

  /// A stretch of closed-form motion from `time` on, `duration` [s] long: a Flight or RampFlight.
  template <class Scalar, class Path>
  void stretch(const Scalar& /*time*/, const Path& /*path*/, const Scalar& /*duration*/) {}

  /// The state after a step within a compliant wall: time [s], position [m], velocity [m/s].
  template <class Scalar>
  void contact(const Scalar& /*time*/, const Scalar& /*position*/, const Scalar& /*velocity*/) {}
};

}  // namespace ricochet::carrier_track::inline models
