#pragma once

#include <optional>

#include "ricochet/scene.h"

/// What the forces of a scene can do to a carrier that rests on a wall: estimates by hand formulas,
/// for constant speeds of the plate.
namespace ricochet::carrier_track::inline scene {

/// The applied force along x at a constant speed, without friction [N]: it swings about a steady
/// part, which presses the carrier on a wall.
struct AppliedForce {
  double steady;  ///< size of the part that does not change
  double swing;   ///< amplitude of the rest; the disturbance adds to it with its whole amplitude
};
AppliedForce applied_force(const Scene& scene, double omega);

/// The speed of the plate [rad/s] from which the force takes the carrier off the wall on which the
/// steady part presses it: swing = steady + friction normal_force. Impacts begin a little later,
/// where it reaches the other wall, or comes back with some speed. Without pull, slider and
/// disturbance this is sqrt(friction normal_force / centrifugal_mass_radius). 0 if every speed
/// does; nothing if no speed up to 1000 rad/s does.
std::optional<double> release_speed(const Scene& scene);

/// The speed [m/s] that the largest applied force at a constant speed of the plate, less friction,
/// gives the carrier across the clearance: sqrt(2 force clearance / mass). 0 if friction holds it;
/// infinite without an upper wall.
double thrown_speed(const Scene& scene, double omega);

}  // namespace ricochet::carrier_track::inline scene
