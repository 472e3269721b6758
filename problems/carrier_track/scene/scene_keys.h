#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ricochet::carrier_track::inline scene {

/// A table of a scene's file and all keys that it may have.
using TableKeys = std::pair<std::string, std::vector<std::string>>;

/// The tables of a scene's file, in their order, with their keys.
const std::vector<TableKeys>& scene_keys();

}  // namespace ricochet::carrier_track::inline scene
