#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "problems/carrier_track/motion/contact_motion.h"
#include "problems/carrier_track/motion/event.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline models {

/// A simulation with more steps in contact than this throws std::runtime_error.
inline constexpr std::int64_t contact_step_limit = 50'000'000;

/// Compliant walls, exact Coulomb friction: flights in closed form, steps only while the body is in
/// a wall (contact_motion.h). Reports to an Observer
///   impact: the beginning of every contact with an approach speed > 0;
///   peak: every maximum of x, in the walls too, except those within the error of the steps;
///   stretch: every flight and every rest; contact: every step in a wall.
/// Inside and outside a wall, a body sticks while the sum of applied and contact force is at most
/// friction.
///
/// The damping of a contact is scaled with its approach speed, or with contact_speed. A body that
/// arrives at most as fast as resting_speed_of the scene, or that rests on a wall when a force
/// presses it in, is put at rest at the depth where the wall balances the press. Its later damping
/// is scaled with the speed of an oscillation in the wall under the largest possible press of the
/// forces.
///
/// There is no Zeno sequence: rebounds slower than about (press / K^(1/(n+1)))^((n+1)/(2n)) end in
/// the wall, and so do those below resting_speed. In a wall with little or no damping
/// (contact_speed far above the impacts) the body oscillates, and every oscillation is simulated.
///
/// For Forces = AppliedForces<double> and ProfileForces<double>.
template <class Forces = AppliedForces<double>>
class CompliantModel {
 public:
  /// `scene` must be valid (scene_check.h) and outlive the model. Tolerance: see ContactMotion.
  explicit CompliantModel(const Scene& scene, double tolerance = 1e-10);

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts or
  /// contact_step_limit steps.
  template <class SomeObserver>
  End<double> run(SomeObserver& observer) {
    for (std::uint32_t events = 0; time_ < duration_; ++events) {
      if (events % events_between_checks == 0) check_time_limit();
      if (direction_ == 0) {
        rest(observer);
      } else if (in_contact_) {
        press(observer);
      } else {
        fly(observer);
      }
    }
    return {time_, position(), velocity_, evaluations_};
  }

 private:
  using Path = typename Forces::Path;

  template <class SomeObserver>
  void fly(SomeObserver& observer) {
    begin_motion(observer);
    const Path path = forces_.flight(offset_, velocity_, -direction_ * friction_);
    const double wall = (direction_ > 0 ? scene_.wall_upper : scene_.wall_lower) - origin_;
    Path there = path;
    const Event event =
        next_event(there, direction_, direction_ * (wall - offset_), horizon(), evaluations_);
    tell(observer, path, event.time);
    forces_.arrive(there, event.time);
    offset_ = there.position;
    velocity_ = there.velocity;
    tick(event.time);
    if (event.kind == EventKind::wall) {
      const double speed = reach_wall();
      if (speed > 0) observer.impact(time_, *wall_, speed);
      if (speed > 0 && speed <= resting_speed_of(scene_)) observer.hops(time_, *wall_);
      enter(speed);
    } else if (event.kind == EventKind::turn) {
      observer.turn(time_, position(), direction_ > 0 ? Wall::upper : Wall::lower);
      stop();
    }
  }

  template <class SomeObserver>
  void press(SomeObserver& observer) {
    begin_motion(observer);
    const ContactEvent event = step();
    observer.contact(time_, position(), velocity_);
    if (event == ContactEvent::turn) stop();
    if (event == ContactEvent::release) {
      in_contact_ = false;
      offset_ = 0;
    }
  }

  template <class SomeObserver>
  void rest(SomeObserver& observer) {
    const Event event = departure();
    tell(observer, Flight<double>{offset_, 0, 0, {}, 0}, event.time);
    forces_.pass(event.time);
    tick(event.time);
    release(event.direction);
  }

  template <class SomeObserver, class SomePath>
  void tell(SomeObserver& observer, SomePath path, double time) {
    path.shift(origin_);
    observer.stretch(time_, path, time);
  }

  template <class SomeObserver>
  void begin_motion(SomeObserver& observer) {
    peaks_.moves(direction_, observer);
    if (!in_contact_) wall_.reset();
  }

  double position() const { return origin_ + offset_; }
  /// +1 where going up leads into the wall touched, else -1.
  int inward() const { return wall_ == Wall::upper ? +1 : -1; }

  double hold(double size) const;
  ContactForce contact_force(double approach_speed) const;
  double reach_wall();
  void enter(double speed);
  void settle();
  double resting_depth(double press) const;
  void stop();
  Event departure();
  void release(int direction);
  ContactEvent step();
  double horizon() const;
  void tick(double time);

  const Scene& scene_;
  double tolerance_;
  double duration_;
  double friction_;  // deceleration [m/s^2]
  Forces forces_;
  std::array<double, 2> damping_{};  // D or damping ratio of the lower and the upper wall

  double time_ = 0;
  // The position is relative to the wall last touched, so that rounding does not affect the depth.
  double origin_;
  double offset_ = 0;
  double velocity_;
  int direction_ = 0;         // of motion along x; 0 at rest
  std::optional<Wall> wall_;  // the wall touched or pressed
  bool in_contact_ = false;
  ContactMotion motion_;
  PeakWatch<double> peaks_;
  std::int64_t evaluations_ = 0;
  std::int64_t impacts_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace ricochet::carrier_track::inline models
