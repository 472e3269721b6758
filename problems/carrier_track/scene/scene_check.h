#pragma once

#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// check() of a scene, see scene.h, for a speed of the driver plate [rad/s] that did not come from
/// a file.
void check_omega(const Scene& scene, const std::string& origin, const std::string& name);

/// Throws InputError if the scene's speed is a profile.
void check_constant_speed(const Scene& scene, const std::string& origin);

/// Returns one sentence, with keys, values and units, for each valid but implausible value of a
/// scene, and for values that do not go together. A braiding machine has carriers of grams to
/// kilograms, on paths of centimetres to a metre, between walls less than a few centimetres apart.
std::vector<std::string> doubts_about(const Scene& scene);

}  // namespace ricochet::carrier_track::inline scene
