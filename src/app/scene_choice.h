#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene_file.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/app/command_line.h"

namespace ricochet::cli {

/// The scene that the user selected: one of the paper's cases, or a machine of the user.
struct SceneChoice {
  std::string case_id;                     ///< of --case, empty if not given
  std::string scene_file;                  ///< of --scene, empty if not given
  std::vector<std::string> settings = {};  ///< of --set, each KEY=VALUE
};

struct ChosenScene {
  std::string name;  ///< the case's id, or the file's stem; with the settings
  std::string interpretation;
  carrier_track::Scene scene;
  carrier_track::Claim claim;       ///< empty for a user's machine, as is a case with settings
  carrier_track::SceneFile source;  ///< says how uncertain the scene's numbers are
};

/// Adds --case, --scene and --set.
void add_scene_choice(CLI::App* command, SceneChoice& choice);

/// Adds the machine file that a command takes, and --set.
void add_machine_file(CLI::App* command, SceneChoice& choice);

/// Throws InputError for an unknown case, an invalid file or setting, or unless exactly one of case
/// and file is given.
ChosenScene choose_scene(const SceneChoice& choice);

/// Every case of the paper, in the default interpretation.
std::vector<ChosenScene> every_case();

}  // namespace ricochet::cli
