#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/models/observer.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline gradients {

/// What ends a leg.
enum class LegEnd {
  cut,     ///< no event of a flight: a knot of the profile, the reach of a series, a release
  impact,  ///< on the wall ahead
  turn     ///< the velocity reaches zero
};

/// A part of a motion, a flight or a rest, in which the forces are one power series.
struct MotionLeg {
  double start;     ///< [s]
  double duration;  ///< [s]
  double velocity;  ///< [m/s] at its start
  bool rests;       ///< the body is at rest
  LegEnd end = LegEnd::cut;
  int direction = 0;    ///< of the flight that contains the leg, or follows it: +1 up, -1 down
  double speed = 0;     ///< [m/s], approach speed of an impact
  double position = 0;  ///< [m], where the event is
  bool peak = false;    ///< the event is a local maximum
};

/// Records the legs of a motion under a speed profile up to its last impact or turning point.
class LegRecord : public Observer {
 public:
  LegRecord() { legs_.reserve(256); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    legs_.push_back({time, duration, path.velocity, std::is_same_v<Path, Flight<double>>});
  }

  void impact(double /*time*/, Wall wall, double speed) { end(LegEnd::impact, wall).speed = speed; }

  void turn(double /*time*/, double position, Wall ahead) {
    end(LegEnd::turn, ahead).position = position;
  }

  /// A maximum is reported when the body leaves it, before any other event.
  void peak(double /*time*/, double position) {
    MotionLeg& summit = legs_[ended_ - 1];
    summit.position = position;
    summit.peak = true;
  }

  std::vector<MotionLeg> legs() && {
    legs_.resize(ended_);
    return std::move(legs_);
  }

 private:
  /// Ends the last leg at an event.
  MotionLeg& end(LegEnd by, Wall ahead) {
    const int direction = ahead == Wall::upper ? +1 : -1;
    for (; ended_ < legs_.size(); ++ended_) legs_[ended_].direction = direction;
    legs_.back().end = by;
    return legs_.back();
  }

  std::vector<MotionLeg> legs_;
  std::size_t ended_ = 0;  // legs up to the last event
};

}  // namespace ricochet::carrier_track::inline gradients
