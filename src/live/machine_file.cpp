#include "src/live/machine_file.h"

#include <fmt/format.h>

#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/error.h"
#include "src/live/flat_scene.h"

namespace ricochet::live {

MachineFile machine_file(const std::string& text, const std::string& origin) {
  const carrier_track::SceneFile file = carrier_track::parse_scene_file(text, origin);
  if (!file.scene.profile.empty()) {
    throw InputError(origin + ": scene.omega is a profile: must be a number on this page");
  }
  MachineFile machine{numbers_of(file.scene), {}};
  for (const carrier_track::Uncertainty& each : file.uncertainties) {
    machine.notes.push_back(
        fmt::format("{} is uncertain in the file: taken at its value, {}", each.key, each.value));
  }
  if (file.scene.across)
    machine.notes.push_back("[across] is left out: this page has one direction");
  return machine;
}

}  // namespace ricochet::live
