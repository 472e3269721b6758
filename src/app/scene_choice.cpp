#include "src/app/scene_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/app/command_line.h"
#include "src/core/names.h"
#include "src/studies/paper/interpretation.h"

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
  add_value(command, "--case", choice.case_id, "A case of the paper",
            fmt::format("CASE:{{{}}}", fmt::join(cases, ",")));
  add_value(command, "--scene", choice.scene_file, "A machine file (TOML); - is standard input",
            "FILE");
  add_settings(command, choice.settings);
}

void add_machine_file(CLI::App* command, SceneChoice& choice) {
  add_value(command, "file", choice.scene_file, "A machine file (TOML); - is standard input",
            "FILE")
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

namespace {

/// The keys of a file whose numbers the calibration fitted.
std::vector<std::string_view> fitted_keys() {
  std::vector<std::string_view> keys;
  for (const carrier_track::Unknown free : carrier_track::default_interpretation().free) {
    const std::string_view name =
        carrier_track::unknown_parameters()[static_cast<std::size_t>(free)].name;
    keys.push_back(name == "clearance" ? "wall_upper" : name);
  }
  return keys;
}

int print_scene(const SceneChoice& choice) {
  const ChosenScene chosen = choose_scene(choice);
  if (!choice.case_id.empty()) {
    fmt::print(
        "# {}, in the default interpretation of the paper. Fitted to the paper's thresholds, not\n"
        "# measured: {}.\n",
        chosen.name, fmt::join(fitted_keys(), ", "));
  }
  fmt::print("{}", carrier_track::write_scene(chosen.scene));
  return 0;
}

}  // namespace

void add_scene(CommandLine& line) {
  CLI::App* command = line.add("scene", "Print a scene as a machine file",
                               "  ricochet scene --case C1 > machine.toml\n"
                               "  ricochet scene --scene machine.toml --set 'path_radius=80 mm'");
  const auto options = std::make_shared<SceneChoice>();
  add_scene_choice(command, *options);
  line.on_call(command, [options] { return print_scene(*options); });
}

}  // namespace ricochet::cli
