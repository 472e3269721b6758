#pragma once

#include <optional>

#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/flight/profile_forces.h"
#include "problems/carrier_track/models/hard_wall_motion.h"
#include "problems/carrier_track/scene/scene.h"
#include "problems/carrier_track/scene/window.h"

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

  /// A search may let a body rest below a faster speed than a judgement does [m/s].
  ImpactModel(const BasicScene<Scalar>& scene, double resting)
      : Base({scene.wall_lower, scene.wall_upper, lower_restitution(scene),
              upper_restitution(scene), scene.start_position, scene.start_velocity},
             Forces(scene), {scene.friction * scene.normal_force / scene.mass}, duration_of(scene),
             resting) {}

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts.
  template <class SomeObserver>
  End<Scalar> run(SomeObserver& observer) {
    if (direction_ == 0) direction_ = this->direction_of_release();
    if (direction_ == 0) velocity_ = constant<Scalar>(0.0);  // friction stops what is that slow
    while (value(time_) < value(duration_)) {
      if (direction_ == 0) {
        const auto rest = this->next_rest();
        this->rest(rest.time, this->after(rest.time), observer);
        direction_ = rest.direction;
      } else {
        move(observer);
      }
    }
    return this->end();
  }

 private:
  template <class SomeObserver>
  [[gnu::always_inline]] void move(SomeObserver& observer) {
    // NOTE: const, the flight is kept in memory by GCC 12, and a simulation takes a tenth longer.
    auto flight = this->flight();
    auto landing = flight;
    const auto end = this->advance_to_event(landing);
    this->pass(flight, landing, end.time, this->after(end.time), observer);
    if (end.kind == EventKind::turn) {
      this->stop();
      direction_ = this->direction_of_release();
    } else if (end.kind == EventKind::wall) {
      this->strike(observer);
      const bool rebounds = value(velocity_) != 0;
      const std::optional<Scalar> hops = this->rest_after_hops();
      if (!hops) return;
      if (rebounds) observer.hops(time_, *wall_);
      this->rest(*hops, this->after(*hops), observer);
      direction_ = this->direction_of_release();
    }
  }
};

}  // namespace ricochet::carrier_track::inline models
