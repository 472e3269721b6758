#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/problems/cases.h"

namespace ricochet::cli {

/// The scene that the user selected: one of the paper's cases, or a machine of the user.
struct SceneChoice {
  std::string case_id;     ///< of --case, empty if not given
  std::string scene_file;  ///< of --scene, empty if not given
};

struct ChosenScene {
  std::string name;  ///< the case's id, or the file's stem
  std::string interpretation;
  carrier_track::Scene scene;
  carrier_track::Claim claim;  ///< empty for a user's machine
};

/// Throws InputError for an unknown case, an invalid file, or unless exactly one of the two is
/// given.
ChosenScene choose_scene(const SceneChoice& choice);

/// Every case of the paper, in the default interpretation.
std::vector<ChosenScene> every_case();

}  // namespace ricochet::cli
