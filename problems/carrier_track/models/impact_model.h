#pragma once

#include <cstdint>
#include <optional>

#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/models/hard_wall_motion.h"
#include "problems/carrier_track/scene/contact_restitution.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline models {

/// Hard walls in one direction, event by event; see HardWallMotion, also for Scalar.
template <class Scalar, class Forces = AppliedForces<Scalar>>
class ImpactModel : HardWallMotion<Scalar, Forces> {
  using Base = HardWallMotion<Scalar, Forces>;
  using Base::direction_, Base::duration_, Base::time_, Base::velocity_, Base::wall_;

 public:
  /// `scene` must be valid (scene_check.h).
  explicit ImpactModel(const BasicScene<Scalar>& scene)
      : ImpactModel(scene, resting_speed_of(scene)) {}

  /// The same with another resting speed [m/s]: a search may use a higher one than the true
  /// objective.
  ImpactModel(const BasicScene<Scalar>& scene, double resting)
      : Base({scene.wall_lower, scene.wall_upper, lower_restitution(scene),
              upper_restitution(scene), scene.start_position, scene.start_velocity},
             Forces(scene), {scene.friction * scene.normal_force / scene.mass}, duration_of(scene),
             resting) {}

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts, and as
  /// check_time_limit() does.
  template <class SomeObserver>
  End<Scalar> run(SomeObserver& observer) {
    begin();
    for (std::uint32_t events = 0; goes_on(); ++events) {
      if (events % events_between_checks == 0) check_time_limit();
      step(observer);
    }
    return this->end();
  }

 private:
  template <class, class>
  friend class ImpactLanes;

  void begin() {
    if (direction_ == 0) direction_ = this->direction_of_release();
    if (direction_ == 0) velocity_ = constant<Scalar>(0.0);  // friction stops a body this slow
  }

  bool goes_on() const { return value(time_) < value(duration_); }

  /// Simulates up to the next event.
  template <class SomeObserver>
  [[gnu::always_inline]] void step(SomeObserver& observer) {
    if (direction_ == 0) {
      const auto rest = this->next_rest();
      this->rest(rest.time, this->after(rest.time), observer);
      direction_ = rest.direction;
    } else {
      move(observer);
    }
  }

  /// Handles the event that fly() found in the body's lane, or the next event if fly() found none.
  /// The model itself follows the lane only if the observer hears stretches.
  template <class SomeObserver>
  void follow(Lanes& lanes, std::size_t k, SomeObserver& observer) {
    const double event = lanes.event[k];
    if (event == Lanes::none) {
      this->leave(lanes, k);
      step(observer);
      this->enter(lanes, k);
      return;
    }
    const bool keeps_up = !SomeObserver::hears_impacts_alone && observer.hears_stretches();
    if (event == Lanes::rested) {
      if (keeps_up) this->rest_as_in(lanes, k, observer);
      direction_ = static_cast<int>(lanes.direction[k]);
      return;
    }
    const bool may_rest =
        event == Lanes::struck && std::abs(lanes.velocity[k]) <= this->resting_speed_;
    if (keeps_up) {
      const auto flight = this->flight();
      auto landing = flight;
      this->land(landing, lanes, k);
      finish(flight, landing,
             {event == Lanes::struck ? EventKind::wall : EventKind::turn, lanes.elapsed[k]},
             observer);
    } else {
      tell_event(lanes, k, observer);
      if (!may_rest) return;
      this->leave(lanes, k);
      rest_on_wall(observer);
    }
    if (may_rest) this->enter(lanes, k);
  }

  /// Reports the impact or turning point that ended the flight of a lane.
  template <class SomeObserver>
  [[gnu::always_inline]] void tell_event(const Lanes& lanes, std::size_t k,
                                         SomeObserver& observer) {
    constexpr bool turns_too = !SomeObserver::hears_impacts_alone;
    const double time = lanes.time[k];
    const double position = lanes.origin[k] + lanes.offset[k];
    if constexpr (turns_too) this->peaks_.moves(direction_, observer);
    if (lanes.event[k] == Lanes::struck) {
      count_impact(this->impacts_);
      observer.impact(time, lanes.wall[k] > 0 ? Wall::upper : Wall::lower, lanes.speed[k]);
    } else if constexpr (turns_too) {
      observer.turn(time, position, direction_ > 0 ? Wall::upper : Wall::lower);
    }
    if constexpr (turns_too) {
      this->peaks_.stops(time, position);
      direction_ = static_cast<int>(lanes.direction[k]);
    }
  }

  template <class SomeObserver>
  [[gnu::always_inline]] void move(SomeObserver& observer) {
    // NOTE: not const: GCC 12 would keep the flight in memory, and a simulation would take 10 %
    // longer.
    auto flight = this->flight();
    auto landing = flight;
    const auto end = this->advance_to_event(landing);
    finish(flight, landing, end, observer);
  }

  /// Lets a flight pass that ends with `end`.
  template <class SomeObserver>
  [[gnu::always_inline]] void finish(const typename Forces::Path& flight,
                                     const typename Forces::Path& landing,
                                     const typename Base::Ending& end, SomeObserver& observer) {
    this->pass(flight, landing, end.time, this->after(end.time), observer);
    if (end.kind == EventKind::turn) {
      this->stop(observer);
      direction_ = this->direction_of_release();
    } else if (end.kind == EventKind::wall) {
      this->strike(observer);
      rest_on_wall(observer);
    }
  }

  /// Stops a body that has struck a wall if its rebounds are a Zeno tail.
  template <class SomeObserver>
  [[gnu::always_inline]] void rest_on_wall(SomeObserver& observer) {
    const bool rebounds = value(velocity_) != 0;
    const std::optional<Scalar> hops = this->rest_after_hops();
    if (!hops) return;
    if (rebounds) observer.hops(time_, *wall_);
    this->rest(*hops, this->after(*hops), observer);
    direction_ = this->direction_of_release();
  }
};

}  // namespace ricochet::carrier_track::inline models
