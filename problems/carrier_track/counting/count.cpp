#include "problems/carrier_track/counting/count.h"

#include <algorithm>
#include <stdexcept>

#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

namespace {

bool is_certain(Scene scene, Fidelity level) {
  scene.fidelity = level;
  try {
    FeatureTrace trace(scene);
    Neighbours neighbours(scene);
    neighbours.simulate_with(scene, trace);
    return certainty_of(scene, trace, neighbours).certain;
  } catch (const std::runtime_error&) {  // more impacts or steps than a simulation may have
    return false;
  }
}

}  // namespace

bool couples(const Scene& scene) {
  if (!scene.across || scene.friction == 0) return false;
  const Across<double>& y = *scene.across;
  const bool starts_free =
      y.start_velocity == 0 && y.start_position > y.wall_lower && y.start_position < y.wall_upper;
  const double strongest = scene.profile.empty() ? AppliedForces<double>::across(scene).strongest()
                                                 : ProfileForces<double>::across(scene).strongest();
  const double friction = scene.friction * scene.normal_force / scene.mass;
  return !starts_free || strongest > friction;
}

Fidelity needed_fidelity(const Scene& scene) {
  if (couples(scene)) return Fidelity::planar;
  if (is_certain(scene, Fidelity::impact)) return Fidelity::impact;
  return is_certain(scene, Fidelity::compliant) ? Fidelity::compliant : Fidelity::impact;
}

Scene resolve_fidelity(const Scene& scene) {
  if (scene.fidelity != Fidelity::automatic) return scene;
  Scene result = scene;
  result.fidelity = needed_fidelity(scene);
  return result;
}

namespace {

struct FastestImpact : Observer {
  double speed = 0;

  void impact(double /*time*/, Wall /*wall*/, double approach) {
    speed = std::max(speed, approach);
  }
};

}  // namespace

double measured(const Scene& scene, Measure measure) {
  switch (measure) {
    case Measure::collisions:
      return objective(scene, 0.0);
    case Measure::collisions_per_turn:
      return objective(scene, 0.0) / turns_of(scene);
    case Measure::energy:
      return 1e-3 * wear(scene);
    case Measure::impact_speed:
      break;
  }
  FastestImpact fastest;
  simulate_at_needed_fidelity(scene, fastest);
  return fastest.speed;
}

std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds) {
  std::vector<double> result;
  if (measure == Measure::collisions) {
    const std::vector<int> counts = counts_at(scene, speeds);
    result.assign(counts.begin(), counts.end());
  } else {
    for (const double omega : speeds) result.push_back(measured(at_speed(scene, omega), measure));
  }
  return result;
}

SpeedScan scan_by(const Scene& scene, const Limit& limit, double step, double highest) {
  const auto loud = [&](double omega) {
    return measured(at_speed(scene, omega), limit.measure) > limit.at_most ? 1 : 0;
  };
  return scan_slowest_speeds(loud, step, highest);
}

}  // namespace ricochet::carrier_track::inline counting
