#include "problems/carrier_track/suite/hard_machines.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/classic/classic.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

namespace ricochet {

std::vector<Family> all_families(const std::string& scene_file) {
  if (!scene_file.empty()) {
    const carrier_track::Scene scene = carrier_track::read_scene(scene_file);
    return carrier_track::families_of({carrier_track::machine_of(scene, scene_file)});
  }
  std::vector<Family> families = carrier_track::case_families();
  families.push_back(carrier_track::hard_family());
  for (Family& family : classic::families()) families.push_back(std::move(family));
  return families;
}

std::vector<Problem> every_problem(const std::vector<Family>& families) {
  std::vector<Problem> all;
  for (const Family& family : families) {
    all.insert(all.end(), family.problems.begin(), family.problems.end());
  }
  return all;
}

}  // namespace ricochet
