#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline scene {

/// What a valid scene allows but what looks like a slip of whoever wrote it: a sentence each, with
/// key and value. A machine that braids yarn has carriers of grams to kilograms between walls that
/// are less than some centimetres apart.
std::vector<std::string> doubts_about(const Scene& scene);

}  // namespace ricochet::carrier_track::inline scene
