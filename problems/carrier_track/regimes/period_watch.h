#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "problems/carrier_track/models/observer.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline regimes {

/// What happens in one period of a motion: its impacts, its rests and its longest flight.
class PeriodWatch : public Observer {
 public:
  /// A time without motion, or a flight, between two events.
  struct Stretch {
    double time = 0;      ///< [s], its start
    double duration = 0;  ///< [s]
    double position = 0;  ///< [m], at its start
  };

  void impact(double time, Wall wall, double speed) {
    if (speed > 0) impacts_.push_back({time, wall, speed});
  }

  void turn(double /*time*/, double position, Wall /*ahead*/) {
    lowest_ = std::min(lowest_, position);
    highest_ = std::max(highest_, position);
  }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (duration <= 0) return;
    if (path.harmonics != 0) {
      if (duration > flight_.duration) flight_ = {time, duration, path.position};
    } else if (!rests_.empty() && rests_.back().time + rests_.back().duration >= time) {
      rests_.back().duration = time + duration - rests_.back().time;
    } else {
      rests_.push_back({time, duration, path.position});
    }
  }

  const std::vector<Impact>& impacts() const { return impacts_; }

  /// The longest flight without an impact or a turning point; duration 0 if there is none.
  const Stretch& longest_flight() const { return flight_; }

  /// The longest rest; nullptr if there is none.
  const Stretch* longest_rest() const {
    const auto longer = [](const Stretch& a, const Stretch& b) { return a.duration < b.duration; };
    return rests_.empty() ? nullptr : &*std::max_element(rests_.begin(), rests_.end(), longer);
  }

  /// [m], of the turning points; lowest > highest if there is none.
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  bool starts_at_rest() const { return !rests_.empty() && rests_.front().time == 0; }

  /// [s], at rest in all.
  double resting() const {
    double sum = 0;
    for (const Stretch& rest : rests_) sum += rest.duration;
    return sum;
  }

  void clear() {
    impacts_.clear();
    rests_.clear();
    flight_ = {};
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
  }

 private:
  std::vector<Impact> impacts_;
  std::vector<Stretch> rests_;
  Stretch flight_;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace ricochet::carrier_track::inline regimes
