#include "problems/carrier_track/counting/counts.h"

#include <algorithm>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/models/impact_lanes.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/recording.h"
#include "ricochet/simulate.h"

namespace ricochet::carrier_track::inline counting {
namespace {

/// Sums the surrogate in the order of the impacts.
struct Surrogate : Observer {
  static constexpr bool hears_impacts_alone = true;

  const Scene* scene = nullptr;
  double smoothing = 0;
  double sum = 0;

  void impact(double time, Wall wall, double speed) {
    auto add = [this](double z, double left) { sum += weight(z, left, smoothing); };
    Features<double, decltype(add)>(*scene, add).impact(time, wall, speed);
  }
};

template <class SceneAt, class SomeObserver>
void run_all(const SceneAt& scene_at, std::vector<SomeObserver>& observers) {
  const auto outcomes = run_in_lanes(
      observers.size(), [&](std::size_t k) { return ImpactModel<double>(scene_at(k)); },
      [&](std::size_t k) -> SomeObserver& { return observers[k]; });
  for (const LaneOutcome& outcome : outcomes) {
    if (outcome.failure) std::rethrow_exception(outcome.failure);
  }
}

}  // namespace

bool suits_lanes(const Scene& scene) {
  return fits_lanes(scene) && scene.rule == CountRule::impacts;
}

std::vector<double> objectives(std::span<const Scene> scenes, double smoothing) {
  std::vector<double> results;
  if (!std::all_of(scenes.begin(), scenes.end(), suits_lanes)) {
    for (const Scene& scene : scenes) results.push_back(objective(scene, smoothing));
    return results;
  }
  std::vector<Surrogate> observers(scenes.size());
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    observers[k].scene = &scenes[k];
    observers[k].smoothing = smoothing;
  }
  run_all([&](std::size_t k) -> const Scene& { return scenes[k]; }, observers);
  for (const Surrogate& observer : observers) results.push_back(observer.sum);
  return results;
}

std::vector<int> counts_at(const Scene& scene, std::span<const double> speeds) {
  std::vector<int> counts;
  Scene there = at_speed(scene, 0.0);
  if (!suits_lanes(there)) {
    for (const double omega : speeds) counts.push_back(count_at(scene, omega));
    return counts;
  }
  std::vector<ImpactCount> observers(speeds.size());
  for (ImpactCount& observer : observers) observer.counting_limit = scene.counting_limit;
  const auto scene_at = [&](std::size_t k) -> const Scene& {
    there.omega = speeds[k];
    return there;
  };
  run_all(scene_at, observers);
  for (const ImpactCount& observer : observers) counts.push_back(observer.count);
  return counts;
}

std::vector<int> counts(const Scene& scene, std::span<const double> speeds) {
  check(scene, "scene");
  for (const double omega : speeds) check_omega(at_speed(scene, omega), "scene", "speed");
  return counts_at(scene, speeds);
}

}  // namespace ricochet::carrier_track::inline counting
