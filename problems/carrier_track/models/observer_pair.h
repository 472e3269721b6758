#pragma once

#include "problems/carrier_track/models/observer.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline models {

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
