#include "problems/carrier_track/models/planar_model.h"

#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline models {
namespace {

template <class Forces>
PlanarFriction<Forces> friction_of(const Scene& scene) {
  return {scene.friction, scene.friction * scene.normal_force / scene.mass};
}

/// The members that x and y have in common.
template <class Direction>
Clearance<double> clearance_of(const Direction& direction) {
  return {direction.wall_lower,        direction.wall_upper,     direction.restitution_lower,
          direction.restitution_upper, direction.start_position, direction.start_velocity};
}

}  // namespace

template <class Forces>
PlanarModel<Forces>::PlanarModel(const Scene& scene)
    : duration_(duration_of(scene)),
      x_(Forces(scene), clearance_of(scene), friction_of<Forces>(scene), duration_,
         resting_speed_of(scene)),
      y_(Forces::across(scene), clearance_of(scene.across.value()), friction_of<Forces>(scene),
         duration_, resting_speed_of(scene)) {}

template class PlanarModel<AppliedForces<double>>;
template class PlanarModel<ProfileForces<double>>;

}  // namespace ricochet::carrier_track::inline models
