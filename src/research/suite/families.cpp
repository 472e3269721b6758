#include "src/research/suite/families.h"

#include "problems/carrier_track/problems/families.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/error.h"
#include "src/research/paper/calibration_problem.h"

namespace ricochet {

std::vector<Family> suite_families(const std::string& scene_file,
                                   const std::vector<std::string>& settings) {
  if (!scene_file.empty()) {
    const carrier_track::Scene scene = carrier_track::read_scene_file(scene_file, settings).scene;
    return carrier_track::families_of({carrier_track::machine_of(scene, scene_file)});
  }
  if (!settings.empty()) {
    throw InputError("--set " + settings.front() + ": changes a machine file: give --scene FILE");
  }
  std::vector<Family> families = all_families();
  families.push_back(carrier_track::calibration_family());
  return families;
}

}  // namespace ricochet
