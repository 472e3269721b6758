#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/scene.h"
#include "src/core/toml_file.h"

namespace ricochet::carrier_track::inline scene {

SceneFile read_scene_file(const std::string& path, const std::vector<std::string>& settings) {
  const bool standard_input = path == "-";
  return parse_scene_file(read_toml_text(standard_input ? "/dev/stdin" : path),
                          standard_input ? "standard input" : path, settings);
}

Scene read_scene(const std::string& path) {
  return read_scene_file(path).scene;
}

}  // namespace ricochet::carrier_track::inline scene
