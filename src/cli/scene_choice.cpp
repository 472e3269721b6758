#include "src/cli/scene_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <utility>

#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/cli/shared_options.h"
#include "src/core/one_line.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

ChosenScene in_default_interpretation(const Case& a_case) {
  const FittedInterpretation& interpretation = default_interpretation();
  return {a_case.id, interpretation.name, scene_of(a_case, interpretation.scene), a_case.claim, {}};
}

/// A machine of the user's own: a file, or a case with settings.
ChosenScene own_machine(std::string name, SceneFile source, const SceneChoice& choice) {
  if (!choice.settings.empty()) {
    name += one_line(fmt::format(" with {}", fmt::join(choice.settings, ", ")));
  }
  Scene scene = source.scene;
  return {std::move(name), "own", std::move(scene), {}, std::move(source)};
}

}  // namespace

void add_scene_choice(CLI::App* command, SceneChoice& choice) {
  std::vector<std::string> cases;
  for (const Case& a_case : all_cases()) cases.push_back(a_case.id);
  command->add_option("--case", choice.case_id, "A case of the paper")
      ->type_name(fmt::format("CASE:{{{}}}", fmt::join(cases, ",")));
  command->add_option("--scene", choice.scene_file, "A machine file (TOML); - is standard input")
      ->type_name("FILE");
  add_settings(command, choice.settings);
}

void add_machine_file(CLI::App* command, SceneChoice& choice) {
  command->add_option("file", choice.scene_file, "A machine file (TOML); - is standard input")
      ->type_name("FILE")
      ->required();
  add_settings(command, choice.settings);
}

ChosenScene choose_scene(const SceneChoice& choice) {
  if (!choice.case_id.empty() && !choice.scene_file.empty()) {
    throw InputError("give only one of --case and --scene, not both");
  }
  if (choice.case_id.empty() && choice.scene_file.empty()) {
    throw InputError("which scene? give --case ID (see `ricochet list cases`) or --scene FILE");
  }
  if (!choice.case_id.empty()) {
    ChosenScene chosen = in_default_interpretation(find_case(choice.case_id));
    if (choice.settings.empty()) return chosen;
    return own_machine(chosen.name,
                       parse_scene_file(write_scene(chosen.scene), chosen.name, choice.settings),
                       choice);
  }
  const std::filesystem::path path = choice.scene_file;
  return own_machine(path.stem().string(), read_scene_file(path, choice.settings), choice);
}

std::vector<ChosenScene> every_case() {
  std::vector<ChosenScene> scenes;
  for (const Case& a_case : all_cases()) scenes.push_back(in_default_interpretation(a_case));
  return scenes;
}

}  // namespace ricochet::cli
