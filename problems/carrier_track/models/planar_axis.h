#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "problems/carrier_track/events/event.h"
#include "problems/carrier_track/events/peak_watch.h"
#include "problems/carrier_track/events/stick_release.h"
#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/models/impact_model.h"

namespace ricochet::carrier_track::inline models {

/// The hard walls of one direction, and how a body starts between them; see BasicScene.
struct Clearance {
  double wall_lower, wall_upper;                ///< [m]
  double restitution_lower, restitution_upper;  ///< in [0, 1]
  double start_position;                        ///< [m]
  double start_velocity;                        ///< [m/s]
};

/// Coulomb friction in one direction: at most steady + coefficient p, where p is the press [m/s^2]
/// on a wall of the other direction.
struct PlanarFriction {
  double coefficient;
  double steady;  ///< [m/s^2]
};

/// One of the two directions of a PlanarModel: where the body is in it, how it moves, and when that
/// ends. Flights are as those of ImpactModel; where nothing couples the directions, so are all
/// numbers, bit for bit. The other direction comes in by its press, of a body that rests on a wall,
/// and by the impulses of its impacts.
///
/// A step of the model is: reach() in both directions, apply_friction_impulse() in both, then
/// go_on() until neither has anything to change.
///
/// For Forces = AppliedForces<double> and ProfileForces<double>.
template <class Forces = AppliedForces<double>>
class PlanarAxis {
 public:
  PlanarAxis(const Forces& forces, const Clearance& clearance, const PlanarFriction& friction,
             double duration);

  /// When something happens next [s]; infinite if nothing does within the window.
  double next() const { return std::min(ends_, press_changes_); }

  /// What happens `now`, if anything does. Returns the impulse [m/s] by mass of an impact, else 0.
  template <class SomeObserver>
  double reach(double now, SomeObserver& observer) {
    if (now == press_changes_) change_press(now);
    if (now != ends_) return 0;
    advance(now, event_.time, observer);
    due_ = true;
    if (event_.kind == EventKind::wall) return strike(observer);
    if (event_.kind == EventKind::turn) stop();
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
    if (velocity_ == 0 && !struck_) stop();
  }

  /// Finds how the body goes on from `now`, if that is due or the other direction's press has begun
  /// or ended. Returns whether it did.
  template <class SomeObserver>
  bool go_on(double now, const PlanarAxis& other, SomeObserver& observer) {
    if (other.press_ != load_direction()) cut(now, observer);
    if (!due_) return false;
    due_ = false;
    load_.reset();
    if (other.press_ != 0) load_ = Load{other.press_, other.forces_at(now)};
    set_out();
    return true;
  }

  /// Ends the motion at the end of the window.
  template <class SomeObserver>
  End<double> finish(SomeObserver& observer) {
    if (time_ < duration_) advance(duration_, duration_ - time_, observer);
    return {time_, origin_ + offset_, velocity_, evaluations_};
  }

  std::int64_t evaluations() const { return evaluations_; }

 private:
  using Path = typename Forces::Path;

  static constexpr double never = std::numeric_limits<double>::infinity();

  /// The press on a wall of the other direction: forces times the direction into that wall.
  struct Load {
    int direction;
    Forces forces;
  };
  int load_direction() const { return load_ ? load_->direction : 0; }

  bool at(Wall wall) const { return wall_ == wall; }
  int inward() const { return at(Wall::upper) ? +1 : -1; }

  /// Lets `elapsed` [s] of the path pass, which ends `now`.
  template <class SomeObserver>
  void advance(double now, double elapsed, SomeObserver& observer) {
    if (direction_ != 0) {
      peaks_.moves(direction_, observer);
      if (wall_ && direction_ != inward()) wall_.reset();
    }
    if (direction_ == 0) {
      observer.stretch(time_, Flight<double>{origin_ + offset_, 0, 0, {}, 0}, elapsed);
      forces_.pass(elapsed);
    } else {
      Path told = *path_;
      told.shift(origin_);
      observer.stretch(time_, told, elapsed);
      if (elapsed != event_.time) {
        landing_ = path_;
        landing_->advance(elapsed);
      }
      offset_ = landing_->position;
      velocity_ = landing_->velocity;
      if (load_) {
        forces_.pass(elapsed);
      } else {
        forces_.arrive(*landing_, elapsed);
      }
    }
    time_ = now;
  }

  /// Ends the path `now`, before its event: what it rests on has changed.
  template <class SomeObserver>
  void cut(double now, SomeObserver& observer) {
    due_ = true;
    if (now > time_) advance(now, now - time_, observer);
    if (direction_ * velocity_ <= 0 && !struck_) stop();
  }

  template <class SomeObserver>
  double strike(SomeObserver& observer) {
    const double approach = meet_wall();
    observer.impact(time_, *wall_, approach);
    return (1 + restitution()) * approach;
  }

  double meet_wall();
  double restitution() const;
  void stop();
  double friction_bound() const;
  int direction_of_release() const;
  std::optional<double> rest_after_hops();
  double horizon() const;
  Event departure();
  void set_out();
  Forces forces_at(double now) const;
  void watch_press(double now, const Forces& forces);
  void change_press(double now);

  Clearance clearance_;
  PlanarFriction friction_;
  double duration_;
  Forces forces_;

  double time_ = 0;  // of the start of the path
  // The position is held from the wall last touched, so that no hop is lost in its rounding.
  double origin_;
  double offset_ = 0;
  double velocity_;
  int direction_;             // of motion; 0 at rest
  std::optional<Wall> wall_;  // the wall touched
  bool struck_ = false;       // the wall is left with velocity_, unless the hops are too small
  PeakWatch<double> peaks_;

  std::optional<Load> load_;     // at the start of the path
  std::optional<Path> path_;     // of a moving body
  std::optional<Path> landing_;  // and where its event finds it
  Event event_{};
  double ends_ = never;
  bool due_ = true;  // the path has ended, and another must be found
  int press_ = 0;    // the direction into the wall where the body rests and is pressed, else 0
  double press_changes_ = never;
  std::int64_t evaluations_ = 0;
  std::int64_t impacts_ = 0;
};

}  // namespace ricochet::carrier_track::inline models
