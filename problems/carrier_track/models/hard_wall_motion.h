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
#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/models/lanes.h"
#include "problems/carrier_track/models/observer.h"
#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline models {

/// A rebound slower than this [m/s] against a pressing force is the tail of a Zeno sequence: its
/// infinitely many impacts are summed in closed form and the body rests.
inline constexpr double resting_speed = 1e-9;

/// The same for a scene where impacts that slow may count: a thousandth of the slowest that does,
/// so that none that counts is left out, and even a surrogate misses nothing.
template <class Scalar>
double resting_speed_of(const BasicScene<Scalar>& scene) {
  return std::min(resting_speed, 1e-3 * value(scene.slowest));
}

/// A simulation with more impacts than this is refused: its window holds no useful count.
inline constexpr std::int64_t impact_limit = 10'000'000;

/// Counts an impact; throws std::runtime_error past impact_limit.
inline void count_impact(std::int64_t& impacts) {
  if (++impacts > impact_limit) {
    throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
  }
}

/// The hard walls of one direction, and how a body starts between them; see BasicScene.
template <class Scalar>
struct Clearance {
  Scalar wall_lower, wall_upper;                ///< [m]
  Scalar restitution_lower, restitution_upper;  ///< in [0, 1]
  Scalar start_position;                        ///< [m]
  Scalar start_velocity;                        ///< [m/s]
};

/// Coulomb friction that does not change. What stands in its place for HardWallMotion says the
/// same.
template <class Scalar>
struct SteadyFriction {
  Scalar steady;  ///< [m/s^2]

  /// The largest friction now [m/s^2].
  const Scalar& bound() const { return steady; }

  /// Sum of the magnitudes [m/s^2] that forces of this size and friction are made of.
  double size(double of_forces) const { return of_forces; }

  /// How long [s] a flight is good for under forces that are good for so long.
  const Scalar& reach(const Scalar& of_forces) const { return of_forces; }

  /// Free flight under the forces and the friction against a direction of motion.
  template <class Forces>
  auto flight(const Forces& forces, const Scalar& position, const Scalar& velocity,
              int direction) const {
    return forces.flight(position, velocity, direction > 0 ? -steady : steady);
  }

  /// When a body at rest, whose path the forces alone would make, sets out; see next_release.
  template <class Path>
  Event release(const Path& held, bool may_rise, bool may_fall, double horizon,
                std::int64_t& evaluations) const {
    return next_release(held.plain(), value(steady), may_rise, may_fall, horizon, evaluations);
  }

  /// Whether more than this and the forces makes a flight.
  static constexpr bool varies() { return false; }
};

// NOTE: what a simulation does for every flight is inlined by force where GCC 12 alone would not;
// calls cost 2-4 %.

/// A body between the hard walls of one direction: Newton restitution, exact Coulomb friction,
/// flights in closed form between events. Whoever derives from it says in which order they come.
///
/// Scalar may be a dual number, or one of more digits than double. Events are then located in plain
/// arithmetic and found exactly from there (event_refinement.h), which gives event times, and all
/// that follows, exact derivatives.
template <class Scalar, class Forces, class Friction = SteadyFriction<Scalar>>
class HardWallMotion {
 protected:
  using Path = typename Forces::Path;

  /// What ends a flight, and how long [s] that lasts.
  struct Ending {
    EventKind kind;
    Scalar time;
  };

  /// How long [s] a rest lasts, and where it leads; 0 if it goes on.
  struct Rest {
    Scalar time;
    int direction;
  };

  HardWallMotion(const Clearance<Scalar>& clearance, const Forces& forces, const Friction& friction,
                 const Scalar& duration, double resting)
      : clearance_(clearance),
        forces_(forces),
        friction_(friction),
        duration_(duration),
        resting_speed_(resting),
        origin_(clearance.start_position),
        velocity_(clearance.start_velocity),
        direction_(direction_of(value(clearance.start_velocity))) {
    if (value(origin_) == value(clearance.wall_lower)) wall_ = Wall::lower;
    if (value(origin_) == value(clearance.wall_upper)) wall_ = Wall::upper;
  }

  bool at(Wall wall) const { return wall_ == wall; }

  const Scalar& restitution() const {
    return at(Wall::upper) ? clearance_.restitution_upper : clearance_.restitution_lower;
  }

  /// Where a body without velocity goes now: friction and a wall behind the force hold it. So does
  /// friction that the forces exceed by rounding alone; next_release tells if they grow.
  [[gnu::always_inline]] int direction_of_release() const {
    const double push = forces_.plain_sum();
    const double friction = value(friction_.bound());
    const double hold = friction + 4 * std::numeric_limits<double>::epsilon() *
                                       (friction + friction_.size(forces_.size()));
    if (push > hold && !at(Wall::upper)) return +1;
    if (push < -hold && !at(Wall::lower)) return -1;
    return 0;
  }

  /// Time until the end of the window, or until the forces have to be taken anew.
  Scalar horizon() const {
    const Scalar left = duration_ - time_;
    const Scalar reach = friction_.reach(forces_.reach());
    return value(reach) < value(left) ? reach : left;
  }

  /// The clock when `time` [s] has passed, which ends exactly with the window.
  Scalar after(const Scalar& time) const {
    return value(time) >= value(duration_) - value(time_) ? duration_ : time_ + time;
  }

  /// The flight of a body that moves, from here.
  Path flight() const { return friction_.flight(forces_, offset_, velocity_, direction_); }

  /// Advances a flight from here to what ends it.
  Ending advance_to_event(Path& flight) {
    const Scalar wall = (direction_ > 0 ? clearance_.wall_upper : clearance_.wall_lower) - origin_;
    const double ahead = direction_ * (value(wall) - value(offset_));
    if constexpr (newton_steps<Scalar> == 0) {
      const Event event = next_event(flight, direction_, ahead, horizon(), evaluations_);
      return {event.kind, event.kind == EventKind::horizon ? horizon() : event.time};
    } else {
      auto there = flight.plain();
      const Event event = next_event(there, direction_, ahead, value(horizon()), evaluations_);
      return {event.kind, refine_event(flight, event, wall, horizon())};
    }
  }

  /// How long a body at rest stays there.
  Rest next_rest() {
    const Path held = forces_.flight(offset_, velocity_, constant<Scalar>(0.0));
    const Event event =
        friction_.release(held, !at(Wall::upper), !at(Wall::lower), value(horizon()), evaluations_);
    if (event.kind == EventKind::horizon) return {horizon(), 0};
    Scalar time = constant<Scalar>(event.time);
    if constexpr (newton_steps<Scalar> != 0) {
      Forces later = forces_;
      later.pass(time);
      for (int i = 0; i < newton_steps<Scalar>; ++i) {
        const Scalar excess =
            later.sum() - (event.direction > 0 ? friction_.steady : -friction_.steady);
        // A force that has jumped out of the band, at a knot, leaves it at a fixed time.
        if (std::abs(value(excess)) > 1e-9 * later.size()) break;
        const Scalar late = -excess / later.rate();
        later.pass(late);
        time += late;
      }
    }
    return {time, event.direction};
  }

  /// Lets `time` [s] of a flight pass, which brings it to `landing` when the clock is `now`.
  template <class SomeObserver>
  void pass(const Path& flight, const Path& landing, const Scalar& time, const Scalar& now,
            SomeObserver& observer) {
    peaks_.moves(direction_, observer);
    flown_ = direction_;
    if (direction_ > 0 ? at(Wall::lower) : at(Wall::upper)) wall_.reset();
    tell(observer, flight, time);
    offset_ = landing.position;
    velocity_ = landing.velocity;
    if (friction_.varies()) {
      forces_.pass(time);
    } else {
      forces_.arrive(landing, time);
    }
    time_ = now;
  }

  /// Lets `time` [s] pass for a body at rest, which ends when the clock is `now`.
  template <class SomeObserver>
  void rest(const Scalar& time, const Scalar& now, SomeObserver& observer) {
    const Scalar zero = constant<Scalar>(0.0);
    tell(observer, Flight<Scalar>{offset_, zero, zero, {}, 0}, time);
    forces_.pass(time);
    time_ = now;
  }

  template <class SomeObserver, class SomePath>
  void tell(SomeObserver& observer, SomePath path, const Scalar& time) {
    path.shift(origin_);
    observer.stretch(time_, path, time);
  }

  /// Puts the body on the wall that it has reached, and turns it round. Returns the approach speed.
  template <class SomeObserver>
  Scalar strike(SomeObserver& observer) {
    count_impact(impacts_);
    wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
    origin_ = at(Wall::upper) ? clearance_.wall_upper : clearance_.wall_lower;
    offset_ = constant<Scalar>(0.0);
    Scalar speed = direction_ > 0 ? velocity_ : -velocity_;
    if (value(speed) < 0) speed = constant<Scalar>(0.0);  // a touch, but for rounding
    observer.impact(time_, *wall_, speed);
    peaks_.stops(time_, origin_ + offset_);
    flown_ = 0;
    direction_ = -direction_;
    const Scalar rebound = restitution() * speed;
    velocity_ = direction_ > 0 ? rebound : constant<Scalar>(0.0) - rebound;  // never -0
    return speed;
  }

  /// Ends the hops of a body that has struck a wall where they are the tail of a Zeno sequence: the
  /// time [s] that they still take, with the body at rest; nothing for one that leaves the wall.
  [[gnu::always_inline]] std::optional<Scalar> rest_after_hops() {
    if (std::abs(value(velocity_)) > resting_speed_) return std::nullopt;
    const Scalar speed = direction_ > 0 ? velocity_ : -velocity_;
    const Scalar press = direction_ > 0 ? -forces_.sum() : forces_.sum();  // into the wall
    const Scalar friction = friction_.bound();
    if (value(press) < -value(friction)) return std::nullopt;  // the force leads away from it
    Scalar remaining = constant<Scalar>(0.0);
    if (value(press) > value(friction) && !vanishes(speed)) {
      remaining = zeno_tail(speed, restitution(), press, friction);
      // The force must keep still over the sum, unless the hops are lost in rounding anyway.
      const double down = value(press) - value(friction);
      const bool still = forces_.jerk_bound() * value(remaining) <= 1e-3 * down &&
                         value(remaining) <= value(friction_.reach(forces_.reach()));
      if (!still && value(speed) > std::min(1e-15, 1e-6 * resting_speed_)) return std::nullopt;
    }
    velocity_ = constant<Scalar>(0.0);
    direction_ = 0;
    if (value(time_) + value(remaining) > value(duration_)) remaining = duration_ - time_;
    return remaining;
  }

  /// The velocity has come down to zero.
  template <class SomeObserver>
  void stop(SomeObserver& observer) {
    velocity_ = constant<Scalar>(0.0);
    direction_ = 0;
    const Scalar position = origin_ + offset_;
    if (flown_ != 0) observer.turn(time_, position, flown_ > 0 ? Wall::upper : Wall::lower);
    flown_ = 0;
    peaks_.stops(time_, position);
  }

  /// Takes its place among others side by side; at constant speed under steady friction alone.
  void enter(Lanes& lanes, std::size_t k) const {
    const Path still = forces_.flight(offset_, velocity_, constant<Scalar>(0.0));
    lanes.steady[k] = still.steady;
    lanes.friction[k] = friction_.steady;
    lanes.wall_lower[k] = clearance_.wall_lower;
    lanes.wall_upper[k] = clearance_.wall_upper;
    lanes.restitution_lower[k] = clearance_.restitution_lower;
    lanes.restitution_upper[k] = clearance_.restitution_upper;
    lanes.duration[k] = duration_;
    lanes.time[k] = time_;
    lanes.origin[k] = origin_;
    lanes.offset[k] = offset_;
    lanes.velocity[k] = velocity_;
    lanes.direction[k] = direction_;
    lanes.wall[k] = !wall_ ? 0 : at(Wall::upper) ? 1 : -1;
    for (std::size_t h = 0; h < still.harmonic.size(); ++h) {
      lanes.frequency[h][k] = still.harmonic[h].frequency;
      lanes.cosine[h][k] = still.harmonic[h].cosine;
      lanes.sine[h][k] = still.harmonic[h].sine;
    }
  }

  /// Goes on by itself from where its place among others is now.
  void leave(const Lanes& lanes, std::size_t k) {
    Path there = flight();
    time_ = lanes.time[k];
    origin_ = lanes.origin[k];
    offset_ = lanes.offset[k];
    velocity_ = lanes.velocity[k];
    direction_ = static_cast<int>(lanes.direction[k]);
    wall_.reset();
    if (lanes.wall[k] != 0) wall_ = lanes.wall[k] > 0 ? Wall::upper : Wall::lower;
    land(there, lanes, k);
    forces_.arrive(there, time_);
  }

  /// Puts a flight from where the model is to where the lane's last one has led.
  void land(Path& flight, const Lanes& lanes, std::size_t k) const {
    flight.position = lanes.offset[k];
    flight.velocity = direction_ * lanes.speed[k];
    for (std::size_t h = 0; h < flight.harmonic.size(); ++h) {
      flight.harmonic[h].cosine = lanes.cosine[h][k];
      flight.harmonic[h].sine = lanes.sine[h][k];
    }
  }

  /// Lets a rest pass that its lane has passed through.
  template <class SomeObserver>
  void rest_as_in(const Lanes& lanes, std::size_t k, SomeObserver& observer) {
    const Scalar zero = constant<Scalar>(0.0);
    tell(observer, Flight<Scalar>{offset_, zero, zero, {}, 0}, lanes.elapsed[k]);
    Path there = flight();
    land(there, lanes, k);
    forces_.arrive(there, lanes.elapsed[k]);
    time_ = lanes.time[k];
    direction_ = static_cast<int>(lanes.direction[k]);
  }

  /// How many harmonics act on it, at constant speed.
  int harmonics() const { return flight().harmonics; }

  End<Scalar> end() const { return {time_, origin_ + offset_, velocity_, evaluations_}; }

  Clearance<Scalar> clearance_;
  Forces forces_;
  Friction friction_;
  Scalar duration_;  // of the window
  double resting_speed_;

  Scalar time_ = constant<Scalar>(0.0);
  // The position is held from the wall last touched, so that no hop is lost in its rounding.
  Scalar origin_;
  Scalar offset_ = constant<Scalar>(0.0);
  Scalar velocity_;
  int direction_;             // of motion; 0 at rest
  int flown_ = 0;             // direction of the last flight, until something ends it
  std::optional<Wall> wall_;  // the wall touched
  PeakWatch<Scalar> peaks_;
  std::int64_t evaluations_ = 0;
  std::int64_t impacts_ = 0;
};

}  // namespace ricochet::carrier_track::inline models
