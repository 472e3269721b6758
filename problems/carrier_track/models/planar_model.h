#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "problems/carrier_track/models/planar_axis.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline models {

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
