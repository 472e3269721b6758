#include "src/research/suite/families.h"

#include "ricochet/families.h"
#include "src/research/paper/calibration_problem.h"

namespace ricochet {

std::vector<Family> suite_families(const std::string& scene_file) {
  std::vector<Family> families = all_families(scene_file);
  if (scene_file.empty()) {
    families.push_back(carrier_track::calibration_family());
  }
  return families;
}

}  // namespace ricochet
