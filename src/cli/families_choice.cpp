#include "src/cli/families_choice.h"

#include "problems/carrier_track/questions/families.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "problems/families.h"

namespace ricochet::cli {

std::vector<Family> choose_families(const std::string& scene_file) {
  using namespace carrier_track;
  if (scene_file.empty()) return all_families();
  return families_of({machine_of(read_scene(scene_file), scene_file)});
}

}  // namespace ricochet::cli
