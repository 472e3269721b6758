#include "problems/carrier_track/questions/machine_grid.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <utility>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/families.h"
#include "problems/carrier_track/scene/scene_check.h"

namespace ricochet::carrier_track::inline questions {
namespace {

std::vector<double> levels_of(const std::vector<double>& named, double own) {
  return named.empty() ? std::vector{own} : named;
}

}  // namespace

std::vector<Family> grid_families(const std::string& around, const std::vector<double>& restitution,
                                  const std::vector<double>& friction,
                                  const std::vector<double>& disturbance) {
  const Case middle = find_case(around);
  std::vector<std::pair<std::string, Scene>> scenes;
  for (const double r : levels_of(restitution, middle.restitution)) {
    for (const double f : levels_of(friction, middle.friction)) {
      for (const double d : levels_of(disturbance, middle.disturbance)) {
        const std::string id = fmt::format("{}-r{}-f{}-d{}", middle.id, r, f, d);
        const Scene scene = scene_of({id, r, f, d, {}}, default_reading().scene);
        check(scene, id);
        scenes.emplace_back(id, scene);
      }
    }
  }
  std::vector<Machine> machines(scenes.size());
  tbb::parallel_for(std::size_t{0}, scenes.size(), [&](std::size_t k) {
    machines[k] = machine_of(scenes[k].second, scenes[k].first);
    machines[k].id = scenes[k].first;
  });
  return families_of(machines);
}

}  // namespace ricochet::carrier_track::inline questions
