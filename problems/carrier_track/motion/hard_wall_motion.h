#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "problems/carrier_track/motion/event.h"
#include "problems/carrier_track/motion/flight.h"
#include "problems/carrier_track/motion/lanes.h"
#include "problems/carrier_track/motion/observer.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline models {

/// A rebound slower than this [m/s] against a pressing force is the tail of a Zeno sequence: its
/// infinitely many impacts are summed in closed form, then the body rests.
inline constexpr double resting_speed = 1e-9;

/// The same for a scene whose counting limit may be that low: at most a thousandth of the counting
/// limit, so that no impact that counts is omitted, and the effect on a surrogate is negligible.
template <class Scalar>
double resting_speed_of(const BasicScene<Scalar>& scene) {
  return std::min(resting_speed, 1e-3 * value(scene.counting_limit));
}

/// A simulation with more impacts than this throws std::runtime_error: its count is of no use.
inline constexpr std::int64_t impact_limit = 10'000'000;

/// Events of a simulation between two looks at its time limit: less than a millisecond.
inline constexpr std::uint32_t events_between_checks = 1024;

/// Counts an impact; throws std::runtime_error past impact_limit.
inline void count_impact(std::int64_t& impacts) {
  if (++impacts > impact_limit) {
    throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
  }
}

/// The hard walls of one direction, and the start of a body between them; see BasicScene.
template <class Scalar>
struct Clearance {
  Scalar wall_lower, wall_upper;                ///< [m]
  Scalar restitution_lower, restitution_upper;  ///< in [0, 1]
  Scalar start_position;                        ///< [m]
  Scalar start_velocity;                        ///< [m/s]
};

/// Constant Coulomb friction. Any other friction of HardWallMotion has the same member functions.
template <class Scalar>
struct SteadyFriction {
  Scalar steady;  ///< [m/s^2]

  /// The largest friction now [m/s^2].
  const Scalar& bound() const { return steady; }

  /// Sum of the magnitudes [m/s^2] of forces of this size and friction.
  double size(double of_forces) const { return of_forces; }

  /// How long [s] a flight is valid under forces that are valid for `of_forces` [s].
  const Scalar& reach(const Scalar& of_forces) const { return of_forces; }

  /// Free flight under the forces and the friction against a direction of motion.
  template <class Forces>
  auto flight(const Forces& forces, const Scalar& position, const Scalar& velocity,
              int direction) const {
    return forces.flight(position, velocity, direction > 0 ? -steady : steady);
  }

  /// When a body at rest starts to move; `held` is its path under the forces alone. See
  /// next_release.
  template <class Path>
  Event release(const Path& held, bool may_rise, bool may_fall, double horizon,
                std::int64_t& evaluations) const {
    return next_release(held.plain(), value(steady), may_rise, may_fall, horizon, evaluations);
  }

  /// Returns true if a flight depends on more than this friction and the forces.
  static constexpr bool varies() { return false; }
};

// NOTE: functions called for every flight are forced inline where GCC 12 would not inline them;
// calls cost 2-4 %.

/// A body between the hard walls of one direction: Newton restitution, exact Coulomb friction,
/// flights in closed form between events. A derived class defines the order of the events.
///
/// Scalar may be a dual number, or a type with more digits than double. Events are then located in
/// plain arithmetic and refined to the accuracy of Scalar (event.h), so that event times
/// and all later values have exact derivatives.
template <class Scalar, class Forces, class Friction = SteadyFriction<Scalar>>
class HardWallMotion {
 protected:
  using Path = typename Forces::Path;

  /// The event that ends a flight, and the flight's duration [s].
  struct Ending {
    EventKind kind;
    Scalar time;
  };

  /// The duration [s] of a rest, and the direction of motion after it; 0 if the rest continues.
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

  /// The direction in which a body without velocity starts to move now, or 0: friction holds it, or
  /// a wall in the direction of the force. Forces that exceed friction by rounding only do not move
  /// it; next_release finds out if they grow.
  [[gnu::always_inline]] int direction_of_release() const {
    const double push = forces_.plain_sum();
    const double friction = value(friction_.bound());
    const double hold = friction + 4 * std::numeric_limits<double>::epsilon() *
                                       (friction + friction_.size(forces_.size()));
    if (push > hold && !at(Wall::upper)) return +1;
    if (push < -hold && !at(Wall::lower)) return -1;
    return 0;
  }

  /// Time until the end of the window, or until the forces must be updated.
  Scalar horizon() const {
    const Scalar left = duration_ - time_;
    const Scalar reach = friction_.reach(forces_.reach());
    return value(reach) < value(left) ? reach : left;
  }

  /// The clock after `time` [s]; at the end of the window it is exactly the duration.
  Scalar after(const Scalar& time) const {
    return value(time) >= value(duration_) - value(time_) ? duration_ : time_ + time;
  }

  /// The flight of a moving body from its current state.
  Path flight() const { return friction_.flight(forces_, offset_, velocity_, direction_); }

  /// Advances a flight from the current state to its next event.
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

  /// Returns how long a body at rest stays at rest.
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
        // A force that jumps out of the friction band, at a knot, leaves it at a fixed time.
        if (std::abs(value(excess)) > 1e-9 * later.size()) break;
        const Scalar late = -excess / later.rate();
        later.pass(late);
        time += late;
      }
    }
    return {time, event.direction};
  }

  /// Lets `time` [s] of a flight pass; it ends at `landing` when the clock is `now`.
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

  /// Lets `time` [s] pass for a body at rest, until the clock is `now`.
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

  /// Puts the body on the wall that it has reached, and reverses it. Returns the approach speed.
  template <class SomeObserver>
  Scalar strike(SomeObserver& observer) {
    count_impact(impacts_);
    wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
    origin_ = at(Wall::upper) ? clearance_.wall_upper : clearance_.wall_lower;
    offset_ = constant<Scalar>(0.0);
    Scalar speed = direction_ > 0 ? velocity_ : -velocity_;
    if (value(speed) < 0) speed = constant<Scalar>(0.0);  // speed 0 except for rounding
    observer.impact(time_, *wall_, speed);
    peaks_.stops(time_, origin_ + offset_);
    flown_ = 0;
    direction_ = -direction_;
    const Scalar rebound = restitution() * speed;
    velocity_ = direction_ > 0 ? rebound : constant<Scalar>(0.0) - rebound;  // never -0
    return speed;
  }

  /// Stops a body that has struck a wall if its rebounds are the tail of a Zeno sequence. Returns
  /// the time [s] that they still take; nothing if the body leaves the wall.
  [[gnu::always_inline]] std::optional<Scalar> rest_after_hops() {
    if (std::abs(value(velocity_)) > resting_speed_) return std::nullopt;
    const Scalar speed = direction_ > 0 ? velocity_ : -velocity_;
    const Scalar press = direction_ > 0 ? -forces_.sum() : forces_.sum();  // into the wall
    const Scalar friction = friction_.bound();
    if (value(press) < -value(friction)) return std::nullopt;  // the force points away from it
    Scalar remaining = constant<Scalar>(0.0);
    if (value(press) > value(friction) && !vanishes(speed)) {
      remaining = zeno_tail(speed, restitution(), press, friction);
      // The force must be constant over the sum, unless the rebounds are below rounding anyway.
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

  /// The velocity has reached zero.
  template <class SomeObserver>
  void stop(SomeObserver& observer) {
    velocity_ = constant<Scalar>(0.0);
    direction_ = 0;
    const Scalar position = origin_ + offset_;
    if (flown_ != 0) observer.turn(time_, position, flown_ > 0 ? Wall::upper : Wall::lower);
    flown_ = 0;
    peaks_.stops(time_, position);
  }

  /// Copies the body into lane `k`; only at constant speed under steady friction.
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

  /// Copies the state of lane `k` back into the body.
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

  /// Sets a flight that starts at the model's state to the end of the lane's last flight.
  void land(Path& flight, const Lanes& lanes, std::size_t k) const {
    flight.position = lanes.offset[k];
    flight.velocity = direction_ * lanes.speed[k];
    for (std::size_t h = 0; h < flight.harmonic.size(); ++h) {
      flight.harmonic[h].cosine = lanes.cosine[h][k];
      flight.harmonic[h].sine = lanes.sine[h][k];
    }
  }

  /// Lets the time pass during which the body has rested in lane `k`.
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

  /// Number of harmonics that act on the body, at constant speed.
  int harmonics() const { return flight().harmonics; }

  End<Scalar> end() const { return {time_, origin_ + offset_, velocity_, evaluations_}; }

  Clearance<Scalar> clearance_;
  Forces forces_;
  Friction friction_;
  Scalar duration_;  // of the window
  double resting_speed_;

  Scalar time_ = constant<Scalar>(0.0);
  // The position is relative to the wall last touched, so that no rebound is lost in rounding.
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
