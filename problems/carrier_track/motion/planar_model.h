#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/hard_wall_motion.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/core/time_limit.h"

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

/// Hard walls in two directions, equations (21) and (22), event-driven in closed form. Friction
/// acts in each direction by itself, as f_x(x') and f_y(y') of the paper: with mu the coefficient
/// of friction and N the normal force,
///   |f_x| <= mu (N + |F_h|),  |f_y| <= mu (N + |F_g|),
/// with equality, and against the velocity, while it slides. F_g and F_h are the contact forces of
/// the walls in x and in y:
///   - A body at rest on a wall is pressed to it by the applied force p(t) into the wall. The wall
///     carries all of it and friction nothing: the law does not determine the shares.
///   - The same holds during the tail of a Zeno sequence, summed in closed form: p is then the mean
///     of its impacts' forces.
///   - An impact at speed v has the impulse m (1 + e) v. In the other direction it takes away
///     min(|v'|, mu (1 + e) v) from the speed v', Coulomb's law for impulses. In an impact in the
///     corner, where both walls are struck at once, each impulse slows the rebound of the other.
/// The press on a wall makes the friction in the other direction vary as the forces do, so a flight
/// is still a steady acceleration and two harmonics, or a power series.
///
/// For Forces = AppliedForces<double> and ProfileForces<double>.
template <class Forces = AppliedForces<double>>
class PlanarModel {
 public:
  /// `scene` must be valid (scene_check.h) and have a second direction, Scene::across.
  explicit PlanarModel(const Scene& scene);

  /// Simulates the window once. Reports x to the observer, and the impacts of y by across_impact.
  /// Returns the end of x, with the evaluations of both. Throws std::runtime_error past
  /// impact_limit impacts in a direction.
  template <class SomeObserver>
  End<double> run(SomeObserver& observer) {
    AcrossImpacts<SomeObserver> across(observer);
    go_on(0, observer, across);
    std::uint32_t events = 0;
    for (double now = next(); std::isfinite(now); now = next()) {
      if (events++ % events_between_checks == 0) check_time_limit();
      const double impulse_x = x_.reach(now, observer);
      const double impulse_y = y_.reach(now, across);
      x_.apply_friction_impulse(now, impulse_y, observer);
      y_.apply_friction_impulse(now, impulse_x, across);
      if (now >= duration_) break;
      go_on(now, observer, across);
    }
    End<double> end = x_.finish(observer);
    end.evaluations += y_.finish(across).evaluations;
    return end;
  }

 private:
  /// Reports the impacts in y and nothing else.
  template <class SomeObserver>
  class AcrossImpacts : public Observer {
   public:
    explicit AcrossImpacts(SomeObserver& observer) : observer_(observer) {}
    void impact(double time, Wall wall, double speed) {
      observer_.across_impact(time, wall, speed);
    }

   private:
    SomeObserver& observer_;
  };

  double next() const { return std::min(x_.next(), y_.next()); }

  /// Updates both directions until neither changes the press on the other.
  template <class SomeObserver>
  void go_on(double now, SomeObserver& observer, AcrossImpacts<SomeObserver>& across) {
    bool changed = true;
    while (changed) {
      changed = x_.go_on(now, y_, observer);
      changed = y_.go_on(now, x_, across) || changed;
    }
  }

  double duration_;
  PlanarAxis<Forces> x_, y_;
};

}  // namespace ricochet::carrier_track::inline models
