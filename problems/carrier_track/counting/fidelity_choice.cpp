#include "problems/carrier_track/counting/fidelity_choice.h"

#include <stdexcept>

#include "problems/carrier_track/counting/certainty.h"

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

}  // namespace ricochet::carrier_track::inline counting
