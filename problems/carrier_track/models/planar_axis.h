#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/models/hard_wall_motion.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline models {

/// Coulomb friction in one direction: at most steady + coefficient p, where p is the press [m/s^2]
/// on a wall of the other direction. For HardWallMotion, like SteadyFriction.
template <class Forces>
struct PlanarFriction {
  using Path = typename Forces::Path;

  /// The press on a wall of the other direction: forces times the direction into that wall.
  struct Load {
    int direction;
    Forces forces;
  };

  double coefficient;
  double steady;               ///< [m/s^2]
  std::optional<Load> load{};  ///< now, if the other direction rests on a wall and is pressed

  double bound() const;
  double size(double of_forces) const;
  double reach(double of_forces) const;
  Path flight(const Forces& forces, double position, double velocity, int direction) const;
  Event release(const Path& held, bool may_rise, bool may_fall, double horizon,
                std::int64_t& evaluations) const;
  bool varies() const { return load.has_value(); }
};

/// One of the two directions of a PlanarModel: the body's position, its motion, and the end of the
/// motion. If nothing couples the directions, all numbers are those of ImpactModel. The other
/// direction acts by its press, if the body rests on a wall, and by the impulses of its impacts.
///
/// A step of the model is: reach() in both directions, apply_friction_impulse() in both, then
/// go_on() until neither changes.
///
/// For Forces = AppliedForces<double> and ProfileForces<double>.
template <class Forces = AppliedForces<double>>
class PlanarAxis : HardWallMotion<double, Forces, PlanarFriction<Forces>> {
  using Base = HardWallMotion<double, Forces, PlanarFriction<Forces>>;
  using Base::clearance_, Base::direction_, Base::duration_, Base::forces_, Base::friction_,
      Base::time_, Base::velocity_, Base::wall_;
  using typename Base::Path;

 public:
  PlanarAxis(const Forces& forces, const Clearance<double>& clearance,
             const PlanarFriction<Forces>& friction, double duration, double resting)
      : Base(clearance, forces, friction, duration, resting) {}

  /// The time of the next event [s]; infinite if there is none within the window.
  double next() const { return std::min(ends_, press_changes_); }

  /// Handles the event at `now`, if there is one. Returns the impulse of an impact divided by the
  /// mass [m/s], else 0.
  template <class SomeObserver>
  double reach(double now, SomeObserver& observer) {
    if (now == press_changes_) change_press(now);
    if (now != ends_) return 0;
    advance(now, event_.time, observer);
    due_ = true;
    if (event_.kind == EventKind::wall) {
      const double approach = this->strike(observer);
      struck_ = true;
      return (1 + this->restitution()) * approach;
    }
    if (event_.kind == EventKind::turn) this->stop(observer);
    if (event_.kind == EventKind::release) direction_ = event_.direction;
    return 0;
  }

  /// Coulomb's law for the impulse [m/s] of an impact of the other direction: sliding slows by up
  /// to coefficient times the impulse.
  template <class SomeObserver>
  void apply_friction_impulse(double now, double impulse, SomeObserver& observer) {
    if (!(impulse > 0) || friction_.coefficient == 0 || direction_ == 0) return;
    cut(now, observer);
    const double speed = std::abs(velocity_);
    velocity_ = direction_ * (speed - std::min(speed, friction_.coefficient * impulse));
    if (velocity_ == 0 && !struck_) this->stop(observer);
  }

  /// Finds the motion from `now` on, if it is due or the other direction's press has begun or
  /// ended. Returns true if it did.
  template <class SomeObserver>
  bool go_on(double now, const PlanarAxis& other, SomeObserver& observer) {
    if (other.press_ != (friction_.load ? friction_.load->direction : 0)) cut(now, observer);
    if (!due_) return false;
    due_ = false;
    friction_.load.reset();
    if (other.press_ != 0) friction_.load = {other.press_, other.forces_at(now)};
    const bool rebounds = struck_ && velocity_ != 0;
    set_out();
    if (rebounds && direction_ == 0) observer.hops(now, *wall_);
    return true;
  }

  /// Ends the motion at the end of the window.
  template <class SomeObserver>
  End<double> finish(SomeObserver& observer) {
    if (time_ < duration_) advance(duration_, duration_ - time_, observer);
    return this->end();
  }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  int inward() const { return this->at(Wall::upper) ? +1 : -1; }

  /// Lets `elapsed` [s] pass, until `now`.
  template <class SomeObserver>
  void advance(double now, double elapsed, SomeObserver& observer) {
    if (direction_ == 0) {
      this->rest(elapsed, now, observer);
      return;
    }
    if (elapsed != event_.time) {
      landing_ = flight_;
      landing_->advance(elapsed);
    }
    this->pass(*flight_, *landing_, elapsed, now, observer);
  }

  /// Ends the path `now`, before its event, because its conditions have changed.
  template <class SomeObserver>
  void cut(double now, SomeObserver& observer) {
    due_ = true;
    if (now > time_) advance(now, now - time_, observer);
    if (direction_ * velocity_ <= 0 && !struck_) this->stop(observer);
  }

  void set_out();
  Forces forces_at(double now) const;
  void watch_press(double now, const Forces& forces);
  void change_press(double now);

  bool struck_ = false;         // leaves the wall with velocity_, unless the rebounds are too small
  std::optional<Path> flight_;  // of a moving body
  std::optional<Path> landing_;  // its state at the event
  Event event_{};                // ends the flight or the rest
  double ends_ = never;          // the time of event_
  bool due_ = true;              // the path has ended, and another must be found
  int press_ = 0;  // the direction into the wall where the body rests and is pressed, else 0
  double press_changes_ = never;
};

}  // namespace ricochet::carrier_track::inline models
