#pragma once

#include "problems/carrier_track/models/hard_wall_motion.h"
#include "problems/carrier_track/scene/window.h"
#include "src/studies/trials/what_if_forces.h"

namespace ricochet::studies::trials {

/// A carrier between hard walls with what a WhatIf changes, event by event. The flights remain
/// closed forms, piece by piece of time: so it costs little more than ImpactModel, and with nothing
/// changed it is that, to the last bit.
class WhatIfMotion : carrier_track::HardWallMotion<double, WhatIfForces, WhatIfFriction> {
  using Base = carrier_track::HardWallMotion<double, WhatIfForces, WhatIfFriction>;

 public:
  /// `scene` must be valid, of a constant speed and outlive it, as must `what_if`. A body that
  /// rebounds slower than `resting` [m/s] may rest.
  WhatIfMotion(const carrier_track::Scene& scene, const WhatIf& what_if, double resting)
      : Base({scene.wall_lower, scene.wall_upper, carrier_track::lower_restitution(scene),
              carrier_track::upper_restitution(scene), scene.start_position, scene.start_velocity},
             WhatIfForces(scene, what_if), friction_of(scene, what_if),
             carrier_track::duration_of(scene), resting),
        scene_(scene),
        what_if_(what_if) {
    friction_.forces = &forces_;
  }
  WhatIfMotion(const WhatIfMotion&) = delete;
  WhatIfMotion& operator=(const WhatIfMotion&) = delete;

  /// Simulates the window once, for a WhatIfObserver. Throws std::runtime_error past impact_limit
  /// impacts.
  template <class SomeObserver>
  carrier_track::End<double> run(SomeObserver& observer) {
    if (direction_ == 0) direction_ = direction_of_release();
    if (direction_ == 0) velocity_ = 0;  // friction stops what is that slow
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
  /// Tells an observer of valleys what it would be told of peaks, were x upside down.
  template <class SomeObserver>
  struct Upside {
    SomeObserver& observer;
    void peak(double time, double position) { observer.valley(time, position); }
  };

  static WhatIfFriction friction_of(const carrier_track::Scene& scene, const WhatIf& what_if) {
    if (!what_if.press) return {scene.friction * scene.normal_force / scene.mass};
    return {0.0, scene.friction * what_if.press->share};
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
    if (!what_if_.restitution) return;
    const double share = carrier_track::returned_share(scene_);
    const bool up = direction_ > 0;
    const double own = up ? scene_.restitution_upper : scene_.restitution_lower;
    (up ? clearance_.restitution_upper : clearance_.restitution_lower) =
        share * what_if_.restitution(std::abs(velocity_), own);
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
  const WhatIf& what_if_;
  carrier_track::PeakWatch<double> valleys_;
};

}  // namespace ricochet::studies::trials
