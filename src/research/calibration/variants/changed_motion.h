#pragma once

#include "problems/carrier_track/models/hard_wall_motion.h"
#include "problems/carrier_track/scene/contact_restitution.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/recording.h"
#include "src/research/calibration/variants/changed_forces.h"

namespace ricochet::studies::variants {

/// A carrier between hard walls with the changes of a MotionChange, event by event. The flights
/// remain in closed form on each interval: so it costs little more than ImpactModel, and without a
/// change it is identical to it, to the last bit.
class ChangedMotion : carrier_track::HardWallMotion<double, ChangedForces, ChangedFriction> {
  using Base = carrier_track::HardWallMotion<double, ChangedForces, ChangedFriction>;

 public:
  /// `scene` must be valid and of constant speed; `scene` and `change` must outlive it. A body that
  /// rebounds slower than `resting` [m/s] may rest.
  ChangedMotion(const carrier_track::Scene& scene, const MotionChange& change, double resting)
      : Base({scene.wall_lower, scene.wall_upper, carrier_track::lower_restitution(scene),
              carrier_track::upper_restitution(scene), scene.start_position, scene.start_velocity},
             ChangedForces(scene, change), friction_of(scene, change),
             carrier_track::duration_of(scene), resting),
        scene_(scene),
        change_(change) {
    friction_.forces = &forces_;
  }
  ChangedMotion(const ChangedMotion&) = delete;
  ChangedMotion& operator=(const ChangedMotion&) = delete;

  /// Simulates the window once, for a VariantObserver. Throws std::runtime_error after more than
  /// impact_limit impacts.
  template <class SomeObserver>
  carrier_track::End<double> run(SomeObserver& observer) {
    if (direction_ == 0) direction_ = direction_of_release();
    if (direction_ == 0) velocity_ = 0;  // friction stops a body this slow
    while (time_ < duration_) {
      if (direction_ == 0) {
        const auto rest_here = next_rest();
        rest(rest_here.time, after(rest_here.time), observer);
        direction_ = rest_here.direction;
        if (direction_ == 0) direction_ = direction_of_release();  // where the force has jumped
      } else {
        move(observer);
      }
    }
    return end();
  }

 private:
  /// Reports minima of x to an observer as maxima of -x.
  template <class SomeObserver>
  struct Upside {
    SomeObserver& observer;
    void peak(double time, double position) { observer.valley(time, position); }
  };

  static ChangedFriction friction_of(const carrier_track::Scene& scene,
                                     const MotionChange& change) {
    if (!change.press) return {scene.friction * scene.normal_force / scene.mass};
    return {0.0, scene.friction * change.press->share};
  }

  template <class SomeObserver>
  void move(SomeObserver& observer) {
    Upside<SomeObserver> upside{observer};
    valleys_.moves(-direction_, upside);
    const auto path = flight();
    auto landing = path;
    const auto end = advance_to_event(landing);
    pass(path, landing, end.time, after(end.time), observer);
    if (end.kind == carrier_track::EventKind::turn) {
      stop(observer);
      valleys_.stops(time_, origin_ + offset_);
      direction_ = direction_of_release();
    } else if (end.kind == carrier_track::EventKind::wall) {
      choose_restitution();
      strike(observer);
      valleys_.stops(time_, origin_ + offset_);
      rest_on_wall(observer);
    }
  }

  void choose_restitution() {
    if (!change_.restitution) return;
    const double share = carrier_track::returned_share(scene_);
    const bool up = direction_ > 0;
    const double own = up ? scene_.restitution_upper : scene_.restitution_lower;
    (up ? clearance_.restitution_upper : clearance_.restitution_lower) =
        share * change_.restitution(std::abs(velocity_), own);
  }

  template <class SomeObserver>
  void rest_on_wall(SomeObserver& observer) {
    const bool rebounds = velocity_ != 0;
    const auto remaining = rest_after_hops();
    if (!remaining) return;
    if (rebounds) observer.hops(time_, *wall_);
    rest(*remaining, after(*remaining), observer);
    direction_ = direction_of_release();
  }

  const carrier_track::Scene& scene_;
  const MotionChange& change_;
  carrier_track::PeakWatch<double> valleys_;
};

}  // namespace ricochet::studies::variants
