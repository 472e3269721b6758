#pragma once

#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// Returns one sentence, with key and value, for each valid but implausible value of a scene. A
/// braiding machine has carriers of grams to kilograms between walls less than a few centimetres
/// apart.
std::vector<std::string> doubts_about(const Scene& scene);

}  // namespace ricochet::carrier_track::inline scene
