#include "problems/carrier_track/check/reference_integrators/wall_force.h"

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/contact_restitution.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

WallForce wall_force_of(const Scene& scene) {
  WallForce wall;
  wall.lower = scene.wall_lower;
  wall.upper = scene.wall_upper;
  wall.stiffness = scene.stiffness / scene.mass;
  wall.viscous = scene.contact_law == ContactLaw::kelvin_voigt;
  wall.exponent = wall.viscous ? 1 : scene.contact_exponent;
  const double unit = wall.viscous ? 2 * std::sqrt(wall.stiffness) : 1;
  wall.lower_damping = unit * damping_factor(scene.contact_law, lower_restitution(scene));
  wall.upper_damping = unit * damping_factor(scene.contact_law, upper_restitution(scene));
  wall.speed = scene.contact_speed.value_or(1);
  return wall;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
