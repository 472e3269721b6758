#include "problems/carrier_track/regimes/disturbed_turn.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <numbers>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/impact_lanes.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

/// Rebounds slower than this share of the counting limit are summed: they are too slow for any
/// margin above lowest_margin.
constexpr double summed_rebounds = 1e-3;

/// Takes the impacts of the last turn.
struct LastTurn : Observer {
  static constexpr bool hears_impacts_alone = true;

  double start = 0;    // [s]
  double slowest = 0;  // [m/s]
  std::vector<Impact> impacts;

  void impact(double time, Wall wall, double speed) {
    if (time >= start && speed > slowest) impacts.push_back({time, wall, speed});
  }
};

}  // namespace

std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before) {
  std::vector<Scene> scenes(phases.size(), scene);
  for (std::size_t k = 0; k < phases.size(); ++k) scenes[k].disturbance_phase = phases[k];
  return turns_of(scenes, before);
}

std::vector<DisturbedTurn> turns_of(std::span<const Scene> scenes, int before) {
  std::vector<LastTurn> last(scenes.size());
  const auto model_at = [&](std::size_t k) {
    Scene there = scenes[k];
    there.window = Revolutions{static_cast<double>(before + 1)};
    last[k].start = before * 2 * std::numbers::pi / there.omega;
    last[k].slowest = std::exp(lowest_margin) * there.counting_limit;
    return ImpactModel<double>(there, summed_rebounds * there.counting_limit);
  };
  std::vector<LaneOutcome> outcomes;
  if (scenes.size() == 1) {
    ImpactModel<double> model = model_at(0);
    outcomes.push_back({model.run(last[0]), nullptr});
  } else {
    outcomes =
        run_in_lanes(scenes.size(), model_at, [&](std::size_t k) -> LastTurn& { return last[k]; });
  }
  std::vector<DisturbedTurn> turns;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    const Scene& scene = scenes[k];
    const End<double>& end = outcomes[k].end;
    DisturbedTurn turn{scene.disturbance_phase,
                       std::move(last[k].impacts),
                       {},
                       0,
                       end.position,
                       end.velocity,
                       false};
    if (end.velocity == 0) {
      turn.returns = end.position == scene.start_position;
      if (end.position == scene.wall_lower) turn.rests_on = Wall::lower;
      if (end.position == scene.wall_upper) turn.rests_on = Wall::upper;
    }
    for (const Impact& impact : turn.impacts) {
      turn.speeds.push_back(impact.speed);
      if (is_counted(impact.speed, scene.counting_limit)) ++turn.collisions;
    }
    std::sort(turn.speeds.begin(), turn.speeds.end(), std::greater<>());
    turns.push_back(std::move(turn));
  }
  return turns;
}

double margin_of(const Scene& scene, const DisturbedTurn& turn, int rank) {
  if (rank < 1 || rank > static_cast<int>(turn.speeds.size())) return lowest_margin;
  const double speed = turn.speeds[static_cast<std::size_t>(rank - 1)];
  return std::max(lowest_margin, std::log(speed / scene.counting_limit));
}

}  // namespace ricochet::carrier_track::inline regimes
