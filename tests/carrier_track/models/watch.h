#pragma once

#include <type_traits>
#include <vector>

#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/simulate.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {

/// All that a simulation tells, in the scalar it was run in.
template <class Scalar>
struct Watched : Observer {
  struct Hit {
    Scalar time;
    Wall wall;
    Scalar speed;
  };
  struct Top {
    Scalar time, position;
  };
  struct Stretch {
    Scalar time;
    Flight<Scalar> flight;
    Scalar duration;
  };

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    hits.push_back({time, wall, speed});
  }
  void across_impact(const Scalar& time, Wall wall, const Scalar& speed) {
    across.push_back({time, wall, speed});
  }
  void peak(const Scalar& time, const Scalar& position) { tops.push_back({time, position}); }
  /// Those of a speed profile are not kept.
  template <class Path>
  void stretch(const Scalar& time, const Path& path, const Scalar& duration) {
    if constexpr (std::is_same_v<Path, Flight<Scalar>>) stretches.push_back({time, path, duration});
  }

  std::vector<Hit> hits;
  std::vector<Hit> across;  ///< in y
  std::vector<Top> tops;
  std::vector<Stretch> stretches;
  End<Scalar> end{};
};

/// Dual numbers run in a model of their own, because simulate() does not report their stretches.
template <class Scalar>
Watched<Scalar> watch(const BasicScene<Scalar>& scene) {
  Watched<Scalar> watched;
  if constexpr (Dual<Scalar>) {
    watched.end = scene.profile.empty()
                      ? ImpactModel<Scalar, AppliedForces<Scalar>>(scene).run(watched)
                      : ImpactModel<Scalar, ProfileForces<Scalar>>(scene).run(watched);
  } else {
    watched.end = simulate(scene, watched);
  }
  return watched;
}

}  // namespace ricochet::carrier_track
