#include "src/cli/machine.h"

#include <fmt/format.h>

#include "embedded/machine_template.h"
#include "problems/carrier_track/advice/study.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_doubts.h"
#include "ricochet/scene.h"
#include "src/cli/tell.h"

namespace ricochet::cli {

int new_machine() {
  fmt::print("{}", embedded::machine_template);
  return 0;
}

int check_machine(const SceneChoice& choice) {
  const ChosenScene chosen = choose_scene(choice);
  fmt::print("{}\n", carrier_track::write_scene(chosen.scene));
  for (const carrier_track::Uncertainty& each : chosen.source.uncertainties) {
    fmt::print("# {} = {} is uncertain by +-{}{}.\n", each.key, each.value, each.plus_minus,
               each.unit == "1" ? "" : " " + each.unit);
  }
  const std::vector<std::string> doubts = carrier_track::doubts_about(chosen.scene);
  for (const std::string& doubt : doubts) fmt::print("# Is it meant? {}\n", doubt);
  fmt::print("# {}: every field is in its range{}.\n", chosen.name,
             doubts.empty() ? ", and nothing looks like a slip"
                            : fmt::format(", {} to look at again", doubts.size()));
  return 0;
}

int advise_machine(const SceneChoice& choice, const QuietSpeedRequest& asked,
                   const std::string& folder) {
  const ChosenScene chosen = choose_scene(choice);
  carrier_track::check_constant_speed(chosen.scene, chosen.name);
  const studies::Study study = studies::advice_study(
      {chosen.name, chosen.scene, options_of(asked), asked.tolerance / 100, chosen.source});
  tell(studies::run(study, false, folder));
  return 0;
}

}  // namespace ricochet::cli
