#include "src/cli/scene_choice.h"

#include <filesystem>

#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

ChosenScene in_default_interpretation(const Case& a_case) {
  const FittedInterpretation& interpretation = default_interpretation();
  return {a_case.id, interpretation.name, scene_of(a_case, interpretation.scene), a_case.claim};
}

}  // namespace

ChosenScene choose_scene(const SceneChoice& choice) {
  if (!choice.case_id.empty() && !choice.scene_file.empty()) {
    throw InputError("give only one of --case and --scene, not both");
  }
  if (choice.case_id.empty() && choice.scene_file.empty()) {
    throw InputError("which scene? give --case ID (see `ricochet list cases`) or --scene FILE");
  }
  if (!choice.case_id.empty()) return in_default_interpretation(find_case(choice.case_id));
  const std::filesystem::path path = choice.scene_file;
  return {path.stem().string(), "own", read_scene(path), {}};
}

std::vector<ChosenScene> every_case() {
  std::vector<ChosenScene> scenes;
  for (const Case& a_case : all_cases()) scenes.push_back(in_default_interpretation(a_case));
  return scenes;
}

}  // namespace ricochet::cli
