#include "ricochet/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "src/cli/commands.h"
#include "src/cli/scene_choice.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::cli {
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
