#include "src/cli/machine.h"

#include <fmt/format.h>

#include "problems/carrier_track/advice/study.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_doubts.h"
#include "ricochet/scene.h"
#include "src/cli/scene_choice.h"
#include "src/cli/tell.h"

namespace ricochet::cli {

int new_machine() {
  fmt::print(
      "# A machine: put in its numbers, then\n"
      "#\n"
      "#   ricochet machine check FILE     what every number means, and what looks like a slip\n"
      "#   ricochet machine advise FILE    the fastest quiet speed, with pictures\n"
      "#\n"
      "# All units are SI. What is left out has its default. These numbers are the paper's first\n"
      "# case.\n\n{}",
      carrier_track::write_scene(choose_scene({"C1", ""}).scene));
  return 0;
}

int check_machine(const std::string& scene_file) {
  const ChosenScene chosen = choose_scene({"", scene_file});
  fmt::print("{}\n", carrier_track::write_scene(chosen.scene));
  const std::vector<std::string> doubts = carrier_track::doubts_about(chosen.scene);
  for (const std::string& doubt : doubts) fmt::print("# Is it meant? {}\n", doubt);
  fmt::print("# {}: every field is in its range{}.\n", chosen.name,
             doubts.empty() ? ", and nothing looks like a slip"
                            : fmt::format(", {} to look at again", doubts.size()));
  return 0;
}

int advise_machine(const std::string& scene_file, const QuietSpeedRequest& asked,
                   const std::string& folder) {
  const ChosenScene chosen = choose_scene({"", scene_file});
  carrier_track::check_constant_speed(chosen.scene, chosen.name);
  const studies::Study study =
      studies::advice_study({chosen.name, chosen.scene, options_of(asked), asked.tolerance / 100});
  tell(studies::run(study, false, folder));
  return 0;
}

}  // namespace ricochet::cli
