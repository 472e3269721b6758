#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/paper/cases.h"

namespace ricochet::cli {

/// Which scene the user asked for: one of the paper's cases, or a machine of their own.
struct SceneChoice {
  std::string case_id;     ///< of --case, empty if not given
  std::string scene_file;  ///< of --scene, empty if not given
};

struct ChosenScene {
  std::string name;  ///< the case's id, or the file's stem
  std::string reading;
  carrier_track::Scene scene;
  carrier_track::Claim claim;  ///< empty for a machine of the user's own
};

/// Throws InputError for an unknown case, a bad file, or anything but one of the two.
ChosenScene choose_scene(const SceneChoice& choice);

/// Every case of the paper, in the default reading.
std::vector<ChosenScene> every_case();

}  // namespace ricochet::cli
