#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "problems/carrier_track/event.h"
#include "problems/carrier_track/flight.h"
#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

enum class Wall { lower, upper };

/// The state in which a simulation ended.
template <class Scalar>
struct End {
  Scalar time;               ///< [s]
  Scalar position;           ///< [m]
  Scalar velocity;           ///< [m/s]
  std::int64_t evaluations;  ///< of the closed-form flight
};

/// What a simulation tells while it runs; observers hide the calls they care for.
struct Observer {
  /// An impact at `time` [s] with approach speed [m/s] >= 0; slow ones too, until the body sticks.
  template <class Scalar>
  void impact(const Scalar& /*time*/, Wall /*wall*/, const Scalar& /*speed*/) {}

  /// A local maximum of x [m], first reached at `time` [s]; the ends of the window are none.
  template <class Scalar>
  void peak(const Scalar& /*time*/, const Scalar& /*position*/) {}

  /// A stretch of closed-form motion from `time` on, `duration` [s] long.
  template <class Scalar>
  void stretch(const Scalar& /*time*/, const Flight<Scalar>& /*flight*/,
               const Scalar& /*duration*/) {}

  /// The state after a step within a compliant wall: time [s], position [m], velocity [m/s].
  template <class Scalar>
  void contact(const Scalar& /*time*/, const Scalar& /*position*/, const Scalar& /*velocity*/) {}
};

/// [s]; the window of a scene. Revolutions need omega > 0.
template <class Scalar>
Scalar duration_of(const BasicScene<Scalar>& scene) {
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    return constant<Scalar>(2 * std::numbers::pi * turns->count) / scene.omega;
  }
  return constant<Scalar>(std::get<Seconds>(scene.window).count);
}

/// A rebound slower than this [m/s] against a pressing force is the tail of a Zeno sequence: its
/// infinitely many impacts are summed in closed form and the body rests.
inline constexpr double resting_speed = 1e-9;

/// A simulation with more impacts than this is refused: its window holds no useful count.
inline constexpr std::int64_t impact_limit = 10'000'000;

/// Hard walls, Newton restitution, exact Coulomb friction: flights in closed form between events.
/// Scalar may be a dual number. Events are then located in plain arithmetic and moved by Newton
/// steps in dual arithmetic, which gives event times, and all that follows, exact derivatives.
template <class Scalar>
class ImpactModel {
 public:
  /// `scene` must be valid (scene_check.h).
  explicit ImpactModel(const BasicScene<Scalar>& scene)
      : scene_(scene),
        duration_(duration_of(scene)),
        friction_(scene.friction * scene.normal_force / scene.mass),
        origin_(scene.start_position),
        velocity_(scene.start_velocity) {
    using std::cos;
    using std::sin;
    const Scalar zero = constant<Scalar>(0.0);
    const Scalar centrifugal = scene.centrifugal_mass_radius * scene.omega * scene.omega;
    Scalar turning = -scene.slider_mass_radius * scene.omega * scene.omega;
    Scalar steady = zero;
    (scene.pull_rotates ? turning : steady) -= scene.pull;
    switch (scene.centrifugal) {
      case Centrifugal::projected:
        turning += centrifugal;
        break;
      case Centrifugal::inward:
        steady -= centrifugal;
        break;
      case Centrifugal::outward:
        steady += centrifugal;
        break;
    }
    steady_ = steady / scene.mass;
    const Scalar amplitude = turning / scene.mass;
    harmonic_[0] = {amplitude * cos(scene.phase), amplitude * sin(scene.phase), scene.omega};
    harmonic_[1] = {scene.disturbance / scene.mass, zero, scene.disturbance_frequency};
    harmonics_ = value(scene.disturbance) == 0.0 ? 1 : 2;
    if (value(scene.start_position) == value(scene.wall_lower)) wall_ = Wall::lower;
    if (value(scene.start_position) == value(scene.wall_upper)) wall_ = Wall::upper;
  }

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts.
  template <class SomeObserver>
  End<Scalar> run(SomeObserver& observer) {
    direction_ = sign(value(velocity_));
    if (direction_ == 0) direction_ = direction_of_departure();
    rising_ = direction_ > 0;
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
  static int sign(double x) { return (x > 0) - (x < 0); }

  Scalar applied() const {
    Scalar sum = steady_;
    for (int i = 0; i < harmonics_; ++i) sum += harmonic_[static_cast<std::size_t>(i)].cosine;
    return sum;
  }

  Flight<Scalar> flight(const Scalar& steady) const {
    return {offset_, velocity_, steady, harmonic_, harmonics_};
  }

  bool at(Wall wall) const { return wall_ == wall; }

  /// Where a body without velocity goes now: friction and a wall behind the force hold it. So does
  /// friction that the forces exceed by rounding alone; next_departure tells if they grow.
  int direction_of_departure() const {
    double push = value(steady_);
    double size = value(friction_) + std::abs(push);
    for (int i = 0; i < harmonics_; ++i) {
      const double cosine = value(harmonic_[static_cast<std::size_t>(i)].cosine);
      push += cosine;
      size += std::abs(cosine);
    }
    const double hold = value(friction_) + 4 * std::numeric_limits<double>::epsilon() * size;
    if (push > hold && !at(Wall::upper)) return +1;
    if (push < -hold && !at(Wall::lower)) return -1;
    return 0;
  }

  template <class SomeObserver>
  void move(SomeObserver& observer) {
    const Scalar sigma = constant<Scalar>(direction_);
    const Scalar wall = (direction_ > 0 ? scene_.wall_upper : scene_.wall_lower) - origin_;
    const Flight<Scalar> path = flight(steady_ - sigma * friction_);
    begin_motion(observer);
    const Event event =
        next_event(path.plain(), direction_, direction_ * (value(wall) - value(offset_)),
                   value(duration_) - value(time_), evaluations_);
    Scalar time = constant<Scalar>(event.time);
    for (int i = 0; i < DerivativeOrder<Scalar>::value; ++i) {
      const Motion<Scalar> m = path.at(time);
      // A wall that is only touched has no derivative; its time is left to be a constant.
      if (event.kind == EventKind::wall && value(m.velocity) != 0.0) {
        time -= (m.position - wall) / m.velocity;
      }
      if (event.kind == EventKind::turn) time -= m.velocity / m.acceleration;
    }
    if (event.kind == EventKind::horizon) time = duration_ - time_;
    tell_stretch(observer, path, time);
    const Motion<Scalar> m = path.at(time, &harmonic_);
    offset_ = m.position;
    velocity_ = m.velocity;
    time_ += time;
    if (event.kind == EventKind::wall) {
      strike(observer);
    } else if (event.kind == EventKind::turn) {
      velocity_ = constant<Scalar>(0.0);
      end_of_rise();
      direction_ = direction_of_departure();
    }
  }

  template <class SomeObserver>
  void strike(SomeObserver& observer) {
    if (++impacts_ > impact_limit) {
      throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
    }
    wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
    origin_ = at(Wall::upper) ? scene_.wall_upper : scene_.wall_lower;
    offset_ = constant<Scalar>(0.0);
    const Scalar speed = constant<Scalar>(direction_) * velocity_;
    observer.impact(time_, *wall_, speed);
    end_of_rise();
    const Scalar restitution =
        at(Wall::upper) ? scene_.restitution_upper : scene_.restitution_lower;
    direction_ = -direction_;
    rebound(observer, restitution * speed, restitution);
  }

  /// Leaves the wall with `speed`, or comes to rest there when a Zeno sequence ends the bouncing.
  template <class SomeObserver>
  void rebound(SomeObserver& observer, const Scalar& speed, const Scalar& restitution) {
    using std::sqrt;
    velocity_ = constant<Scalar>(direction_) * speed;
    if (value(speed) > resting_speed) return;
    const Scalar press = -constant<Scalar>(direction_) * applied();  // into the wall
    if (value(press) < -value(friction_)) {  // the force leads away from the wall
      if (value(speed) == 0) velocity_ = constant<Scalar>(0.0);
      return;
    }
    Scalar remaining = constant<Scalar>(0.0);
    if (value(press) > value(friction_) && value(speed) > 0) {
      // Each hop slows by press + friction and falls by press - friction: a geometric series.
      const Scalar up = press + friction_;
      const Scalar down = press - friction_;
      const Scalar ratio = restitution * sqrt(down / up);
      remaining = speed * (constant<Scalar>(1.0) / up + constant<Scalar>(1.0) / sqrt(up * down)) /
                  (constant<Scalar>(1.0) - ratio);
      // The force must keep still over the sum, unless the hops are lost in rounding anyway.
      if (jerk_bound() * value(remaining) > 1e-3 * value(down) && value(speed) > 1e-15) return;
    }
    velocity_ = constant<Scalar>(0.0);
    direction_ = 0;
    if (value(time_) + value(remaining) > value(duration_)) remaining = duration_ - time_;
    tell_rest(observer, remaining);
    pass(remaining);
    direction_ = direction_of_departure();
  }

  template <class SomeObserver>
  void rest(SomeObserver& observer) {
    const Flight<Scalar> held = flight(steady_);
    const Event event =
        next_departure(held.plain(), value(friction_), !at(Wall::upper), !at(Wall::lower),
                       value(duration_) - value(time_), evaluations_);
    Scalar time = constant<Scalar>(event.time);
    for (int i = 0; i < DerivativeOrder<Scalar>::value && event.kind == EventKind::depart; ++i) {
      ImpactModel later = *this;
      later.pass(time);
      const Scalar excess = later.applied() - constant<Scalar>(event.direction) * friction_;
      time -= excess / later.flight(steady_).jerk();
    }
    if (event.kind == EventKind::horizon) time = duration_ - time_;
    tell_rest(observer, time);
    pass(time);
    direction_ = event.direction;
  }

  template <class SomeObserver>
  void tell_stretch(SomeObserver& observer, Flight<Scalar> path, const Scalar& time) {
    path.position += origin_;
    observer.stretch(time_, path, time);
  }

  template <class SomeObserver>
  void tell_rest(SomeObserver& observer, const Scalar& time) {
    const Scalar zero = constant<Scalar>(0.0);
    tell_stretch(observer, Flight<Scalar>{offset_, zero, zero, harmonic_, 0}, time);
  }

  /// Lets `time` pass for the clock and the harmonics' angles; the angles keep unit amplitude.
  void pass(const Scalar& time) {
    time_ += time;
    for (int i = 0; i < harmonics_; ++i) {
      auto& h = harmonic_[static_cast<std::size_t>(i)];
      const Scalar u = h.frequency * time;
      const auto [c2, c3] = stumpff(u);
      const Scalar cosine = constant<Scalar>(1.0) - u * u * c2;
      const Scalar sine = u * (constant<Scalar>(1.0) - u * u * c3);
      h = {h.cosine * cosine - h.sine * sine, h.sine * cosine + h.cosine * sine, h.frequency};
    }
  }

  double jerk_bound() const {
    double bound = 0;
    for (int i = 0; i < harmonics_; ++i) {
      const auto& h = harmonic_[static_cast<std::size_t>(i)];
      bound += std::hypot(value(h.cosine), value(h.sine)) * value(h.frequency);
    }
    return bound;
  }

  void end_of_rise() {
    if (rising_ && !summit_) summit_ = Summit{time_, origin_ + offset_};
  }

  /// A maximum is certain once the body has moved down from it; a plateau counts once, at its
  /// start.
  template <class SomeObserver>
  void begin_motion(SomeObserver& observer) {
    if (direction_ < 0 && summit_) observer.peak(summit_->time, summit_->position);
    summit_.reset();
    rising_ = direction_ > 0;
    if (direction_ > 0 ? at(Wall::lower) : at(Wall::upper)) wall_.reset();
  }

  struct Summit {
    Scalar time, position;
  };

  const BasicScene<Scalar>& scene_;
  Scalar duration_;
  Scalar friction_;  // deceleration [m/s^2]
  Scalar steady_;    // [m/s^2]
  std::array<Harmonic<Scalar>, 2> harmonic_;
  int harmonics_ = 2;

  Scalar time_ = constant<Scalar>(0.0);
  // The position is held from the wall last touched, so that no hop is lost in its rounding.
  Scalar origin_;
  Scalar offset_ = constant<Scalar>(0.0);
  Scalar velocity_;
  int direction_ = 0;         // of motion; 0 at rest
  std::optional<Wall> wall_;  // the wall touched
  bool rising_ = false;
  std::optional<Summit> summit_;
  std::int64_t evaluations_ = 0;
  std::int64_t impacts_ = 0;
};

}  // namespace ricochet::carrier_track
