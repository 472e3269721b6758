#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "problems/carrier_track/events/event.h"
#include "problems/carrier_track/events/event_refinement.h"
#include "problems/carrier_track/events/peak_watch.h"
#include "problems/carrier_track/events/stick_release.h"
#include "problems/carrier_track/events/zeno_tail.h"
#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/models/observer.h"
#include "problems/carrier_track/scene/scene.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline models {

/// A rebound slower than this [m/s] against a pressing force is the tail of a Zeno sequence: its
/// infinitely many impacts are summed in closed form and the body rests.
inline constexpr double resting_speed = 1e-9;

/// A simulation with more impacts than this is refused: its window holds no useful count.
inline constexpr std::int64_t impact_limit = 10'000'000;

/// Counts an impact; throws std::runtime_error past impact_limit.
inline void count_impact(std::int64_t& impacts) {
  if (++impacts > impact_limit) {
    throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
  }
}

/// Hard walls, Newton restitution, exact Coulomb friction: flights in closed form between events.
/// Scalar may be a dual number, or one of more digits than double. Events are then located in plain
/// arithmetic and found exactly from there (event_refinement.h), which gives event times, and all
/// that follows, exact derivatives.
template <class Scalar, class Forces = AppliedForces<Scalar>>
class ImpactModel {
 public:
  /// `scene` must be valid (scene_check.h). A search may let a body rest below a faster speed than
  /// a judgement does [m/s].
  explicit ImpactModel(const BasicScene<Scalar>& scene, double resting = resting_speed)
      : scene_(scene),
        resting_speed_(resting),
        duration_(duration_of(scene)),
        friction_(scene.friction * scene.normal_force / scene.mass),
        lower_restitution_(lower_restitution(scene)),
        upper_restitution_(upper_restitution(scene)),
        forces_(scene),
        origin_(scene.start_position),
        velocity_(scene.start_velocity) {
    if (value(scene.start_position) == value(scene.wall_lower)) wall_ = Wall::lower;
    if (value(scene.start_position) == value(scene.wall_upper)) wall_ = Wall::upper;
  }

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts.
  template <class SomeObserver>
  End<Scalar> run(SomeObserver& observer) {
    direction_ = direction_of(value(velocity_));
    if (direction_ == 0) direction_ = direction_of_release();
    if (direction_ == 0) velocity_ = constant<Scalar>(0.0);  // friction stops what is that slow
    while (value(time_) < value(duration_)) {
      if (direction_ == 0) {
        rest(observer);
      } else {
        move(observer);
      }
    }
    return {time_, origin_ + offset_, velocity_, evaluations_};
  }

 private:
  using Path = typename Forces::Path;

  bool at(Wall wall) const { return wall_ == wall; }

  /// Where a body without velocity goes now: friction and a wall behind the force hold it. So does
  /// friction that the forces exceed by rounding alone; next_release tells if they grow.
  int direction_of_release() const {
    const double push = forces_.plain_sum();
    const double hold = value(friction_) + 4 * std::numeric_limits<double>::epsilon() *
                                               (value(friction_) + forces_.size());
    if (push > hold && !at(Wall::upper)) return +1;
    if (push < -hold && !at(Wall::lower)) return -1;
    return 0;
  }

  template <class SomeObserver>
  void move(SomeObserver& observer) {
    const Scalar wall = (direction_ > 0 ? scene_.wall_upper : scene_.wall_lower) - origin_;
    Path path = forces_.flight(offset_, velocity_, direction_ > 0 ? -friction_ : friction_);
    begin_motion(observer);
    auto there = path.plain();
    const Event event = next_event(there, direction_, direction_ * (value(wall) - value(offset_)),
                                   value(horizon()), evaluations_);
    if constexpr (newton_steps<Scalar> == 0) {
      const Scalar time = event.kind == EventKind::horizon ? horizon() : event.time;
      tell_stretch(observer, path, time);
      arrive(there, time);
    } else {
      Path landing = path;
      const Scalar time = refine_event(landing, event, wall, horizon());
      tell_stretch(observer, path, time);
      arrive(landing, time);
    }
    if (event.kind == EventKind::wall) {
      strike(observer);
    } else if (event.kind == EventKind::turn) {
      velocity_ = constant<Scalar>(0.0);
      peaks_.stops(time_, origin_ + offset_);
      direction_ = direction_of_release();
    }
  }

  /// Time until the end of the window, or until the forces have to be taken anew.
  Scalar horizon() const {
    const Scalar left = duration_ - time_;
    const Scalar reach = forces_.reach();
    return value(reach) < value(left) ? reach : left;
  }

  void arrive(const Path& there, const Scalar& time) {
    offset_ = there.position;
    velocity_ = there.velocity;
    forces_.arrive(there, time);
    tick(time);
  }

  /// Lets `time` pass for the clock, which ends exactly with the window.
  void tick(const Scalar& time) {
    const bool last = value(time) >= value(duration_) - value(time_);
    time_ = last ? duration_ : time_ + time;
  }

  template <class SomeObserver>
  void strike(SomeObserver& observer) {
    count_impact(impacts_);
    wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
    origin_ = at(Wall::upper) ? scene_.wall_upper : scene_.wall_lower;
    offset_ = constant<Scalar>(0.0);
    Scalar speed = direction_ > 0 ? velocity_ : -velocity_;
    if (value(speed) < 0) speed = constant<Scalar>(0.0);  // a touch, but for rounding
    observer.impact(time_, *wall_, speed);
    peaks_.stops(time_, origin_ + offset_);
    const Scalar restitution = at(Wall::upper) ? upper_restitution_ : lower_restitution_;
    direction_ = -direction_;
    rebound(observer, restitution * speed, restitution);
  }

  /// Leaves the wall with `speed`, or comes to rest there when a Zeno sequence ends the bouncing.
  template <class SomeObserver>
  void rebound(SomeObserver& observer, const Scalar& speed, const Scalar& restitution) {
    velocity_ = direction_ > 0 ? speed : constant<Scalar>(0.0) - speed;  // never -0
    if (value(speed) > resting_speed_) return;
    const Scalar press = direction_ > 0 ? -forces_.sum() : forces_.sum();  // into the wall
    if (value(press) < -value(friction_)) return;  // the force leads away from the wall
    Scalar remaining = constant<Scalar>(0.0);
    if (value(press) > value(friction_) && !vanishes(speed)) {
      remaining = zeno_tail(speed, restitution, press, friction_);
      // The force must keep still over the sum, unless the hops are lost in rounding anyway.
      const double down = value(press) - value(friction_);
      const bool still = forces_.jerk_bound() * value(remaining) <= 1e-3 * down &&
                         value(remaining) <= value(forces_.reach());
      if (!still && value(speed) > 1e-15) return;
    }
    velocity_ = constant<Scalar>(0.0);
    direction_ = 0;
    if (value(time_) + value(remaining) > value(duration_)) remaining = duration_ - time_;
    tell_rest(observer, remaining);
    pass(remaining);
    direction_ = direction_of_release();
  }

  template <class SomeObserver>
  void rest(SomeObserver& observer) {
    const Path held = forces_.flight(offset_, velocity_, constant<Scalar>(0.0));
    const Event event = next_release(held.plain(), value(friction_), !at(Wall::upper),
                                     !at(Wall::lower), value(horizon()), evaluations_);
    Scalar time = constant<Scalar>(event.time);
    if (newton_steps < Scalar >> 0 && event.kind == EventKind::release) {
      Forces later = forces_;
      later.pass(time);
      for (int i = 0; i < newton_steps<Scalar>; ++i) {
        const Scalar excess = later.sum() - (event.direction > 0 ? friction_ : -friction_);
        // A force that has jumped out of the band, at a knot, leaves it at a fixed time.
        if (std::abs(value(excess)) > 1e-9 * later.size()) break;
        const Scalar late = -excess / later.rate();
        later.pass(late);
        time += late;
      }
    }
    if (event.kind == EventKind::horizon) time = horizon();
    tell_rest(observer, time);
    pass(time);
    direction_ = event.direction;
  }

  template <class SomeObserver, class SomePath>
  void tell_stretch(SomeObserver& observer, SomePath path, const Scalar& time) {
    path.shift(origin_);
    observer.stretch(time_, path, time);
  }

  template <class SomeObserver>
  void tell_rest(SomeObserver& observer, const Scalar& time) {
    const Scalar zero = constant<Scalar>(0.0);
    tell_stretch(observer, Flight<Scalar>{offset_, zero, zero, {}, 0}, time);
  }

  void pass(const Scalar& time) {
    tick(time);
    forces_.pass(time);
  }

  template <class SomeObserver>
  void begin_motion(SomeObserver& observer) {
    peaks_.moves(direction_, observer);
    if (direction_ > 0 ? at(Wall::lower) : at(Wall::upper)) wall_.reset();
  }

  const BasicScene<Scalar>& scene_;
  double resting_speed_;
  Scalar duration_;
  Scalar friction_;  // deceleration [m/s^2]
  Scalar lower_restitution_, upper_restitution_;
  Forces forces_;

  Scalar time_ = constant<Scalar>(0.0);
  // The position is held from the wall last touched, so that no hop is lost in its rounding.
  Scalar origin_;
  Scalar offset_ = constant<Scalar>(0.0);
  Scalar velocity_;
  int direction_ = 0;         // of motion; 0 at rest
  std::optional<Wall> wall_;  // the wall touched
  PeakWatch<Scalar> peaks_;
  std::int64_t evaluations_ = 0;
  std::int64_t impacts_ = 0;
};

}  // namespace ricochet::carrier_track::inline models
