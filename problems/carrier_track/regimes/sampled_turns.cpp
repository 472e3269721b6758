#include "problems/carrier_track/regimes/sampled_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/impact_lanes.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr int sampled_speeds = 24;

/// Collisions by the turn in which they happen.
struct TurnCounts : Observer {
  static constexpr bool hears_impacts_alone = true;

  double counting_limit = 0;
  double period = 0;  ///< [s], of a turn
  std::vector<int> counts = std::vector<int>(2 * sampled_turns_each);

  void impact(double time, Wall /*wall*/, double speed) {
    if (!is_counted(speed, counting_limit)) return;
    const auto index = static_cast<std::size_t>(time / period);
    ++counts[std::min(index, counts.size() - 1)];
  }
};

SampledTurns turns_at(const Scene& machine, double omega) {
  Scene scene = at_speed(machine, omega);
  scene.fidelity = Fidelity::impact;
  begin_turns_at_rest(scene);
  scene.window = Revolutions{2 * sampled_turns_each};
  const auto phases = static_cast<std::size_t>(is_disturbed(scene) ? sampled_phases : 1);
  TurnCounts none;
  none.counting_limit = scene.counting_limit;
  none.period = 2 * std::numbers::pi / omega;
  std::vector<TurnCounts> heard(phases, none);
  const auto model_at = [&](std::size_t k) {
    Scene there = scene;
    there.disturbance_phase +=
        2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(phases);
    return ImpactModel<double>(there);
  };
  const auto outcomes =
      run_in_lanes(phases, model_at, [&](std::size_t k) -> TurnCounts& { return heard[k]; });
  SampledTurns result{omega, 0, 0};
  for (std::size_t k = 0; k < phases; ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    const auto settled = heard[k].counts.begin() + sampled_turns_each;
    const int all = std::accumulate(settled, heard[k].counts.end(), 0);
    result.mean_per_turn += all / static_cast<double>(phases * sampled_turns_each);
    result.most_per_turn =
        std::max(result.most_per_turn, *std::max_element(settled, heard[k].counts.end()));
  }
  return result;
}

}  // namespace

std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to) {
  std::vector<SampledTurns> sampled;
  try {
    // A turn at a slow speed takes longest.
    for (int k = sampled_speeds - 1; k >= 0; --k) {
      report_progress("simulations at single speeds", 1 - (k + 1.0) / sampled_speeds);
      const double omega =
          k == sampled_speeds - 1 ? to : from * std::pow(to / from, k / (sampled_speeds - 1.0));
      sampled.push_back(turns_at(scene, omega));
    }
  } catch (const TimeLimitReached&) {
    // The speeds that had time are returned.
  }
  std::ranges::reverse(sampled);
  return sampled;
}

}  // namespace ricochet::carrier_track::inline regimes
