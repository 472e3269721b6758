#pragma once

#include <string>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// check() of a scene, see scene.h, for a speed of the driver plate [rad/s] that did not come from
/// a file.
void check_omega(const Scene& scene, const std::string& origin, const std::string& name);

/// Throws InputError if the scene's speed is a profile.
void check_constant_speed(const Scene& scene, const std::string& origin);

}  // namespace ricochet::carrier_track::inline scene
