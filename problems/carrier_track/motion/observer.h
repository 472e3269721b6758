#pragma once

#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline models {

/// The events that a simulation reports while it runs. An observer hides the functions that it
/// needs.
struct Observer {
  /// True if the observer needs impacts only; the other calls are then omitted.
  static constexpr bool hears_impacts_alone = false;

  /// Returns true if the observer needs stretches; constant during a simulation. Stretches may be
  /// reported even if not.
  static constexpr bool hears_stretches() { return true; }

  /// An impact at `time` [s] with approach speed [m/s] >= 0; slow impacts too, until the body
  /// sticks.
  template <class Scalar>
  void impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& /*speed*/) {}

  /// An impact on a wall of the second direction, y, of fidelity planar. It does not count.
  template <class Scalar>
  void across_impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& /*speed*/) {}

  /// A local maximum of x [m], first reached at `time` [s]; the ends of the window are not maxima.
  template <class Scalar>
  void peak(const Scalar& /*time*/, const Scalar& /*position*/) {}

  /// At `time` [s] the body, which moved towards the wall `ahead`, has come to a stop at `position`
  /// [m] without touching it.
  template <class Scalar>
  void turn(const Scalar& /*time*/, const Scalar& /*position*/, Wall /*ahead*/) {}

  /// Infinitely many rebounds on a wall from `time` [s] on, summed and not reported one by one.
  template <class Scalar>
  void hops(const Scalar& /*time*/, Wall /*wall*/) {}

  /// A stretch of motion in closed form from `time` on, `duration` [s] long: a Flight or
  /// RampFlight.
  template <class Scalar, class Path>
  void stretch(const Scalar& /*time*/, const Path& /*path*/, const Scalar& /*duration*/) {}

  /// The state after a step within a compliant wall: time [s], position [m], velocity [m/s].
  template <class Scalar>
  void contact(const Scalar& /*time*/, const Scalar& /*position*/, const Scalar& /*velocity*/) {}
};

/// Passes every call of a simulation to two observers, one after the other.
template <class First, class Second>
class ObserverPair : public Observer {
 public:
  ObserverPair(First& first, Second& second) : first_(first), second_(second) {}

  bool hears_stretches() const { return first_.hears_stretches() || second_.hears_stretches(); }

  template <class Scalar>
  [[gnu::always_inline]] void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    first_.impact(time, wall, speed);
    second_.impact(time, wall, speed);
  }

  template <class Scalar>
  void across_impact(const Scalar& time, Wall wall, const Scalar& speed) {
    first_.across_impact(time, wall, speed);
    second_.across_impact(time, wall, speed);
  }

  template <class Scalar>
  void peak(const Scalar& time, const Scalar& position) {
    first_.peak(time, position);
    second_.peak(time, position);
  }

  template <class Scalar>
  void turn(const Scalar& time, const Scalar& position, Wall ahead) {
    first_.turn(time, position, ahead);
    second_.turn(time, position, ahead);
  }

  template <class Scalar>
  void hops(const Scalar& time, Wall wall) {
    first_.hops(time, wall);
    second_.hops(time, wall);
  }

  template <class Scalar, class Path>
  void stretch(const Scalar& time, const Path& path, const Scalar& duration) {
    first_.stretch(time, path, duration);
    second_.stretch(time, path, duration);
  }

  template <class Scalar>
  void contact(const Scalar& time, const Scalar& position, const Scalar& velocity) {
    first_.contact(time, position, velocity);
    second_.contact(time, position, velocity);
  }

 private:
  First& first_;
  Second& second_;
};

}  // namespace ricochet::carrier_track::inline models
