#include "problems/carrier_track/regimes/disturbed_turn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <numbers>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Rebounds slower than this share of the counting limit are summed where the force hardly changes:
/// they are too slow for any margin above lowest_margin.
constexpr double summed_rebounds = 0.1;

/// Takes the impacts of a turn.
struct CollectedImpacts : Observer {
  static constexpr bool hears_impacts_alone = true;

  double slowest = 0;  // [m/s]
  std::vector<Impact> all;

  void impact(double time, Wall wall, double speed) {
    if (speed > slowest) all.push_back({time, wall, speed});
  }
};

DisturbedTurn turn_with(std::vector<Impact> impacts, const TurnStart& start, double limit,
                        const End<double>& end) {
  DisturbedTurn turn{start.phase,    std::move(impacts), {},           lowest_margin, 0,
                     start.position, start.velocity,     end.position, end.velocity};
  for (const Impact& impact : turn.impacts) {
    turn.margins.push_back(std::log(impact.speed / limit));
    if (is_counted(impact.speed, limit)) ++turn.collisions;
  }
  if (!turn.margins.empty()) turn.first = turn.margins.front();
  std::sort(turn.margins.begin(), turn.margins.end(), std::greater<>());
  return turn;
}

/// Simulates some turns that end at the phases of these starts, or begin there.
template <class ObserverAt>
std::vector<LaneOutcome> fly(const Scene& scene, std::span<const TurnStart> starts, int turns,
                             int before, const ObserverAt& observer_at) {
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(turns)};
  const auto model_at = [&](std::size_t k) {
    const TurnStart& start = starts[k];
    there.phase = scene.phase;
    there.omega = start.omega;
    if (start.omega != scene.omega) begin_turns_at_rest(there);
    there.disturbance_phase =
        start.phase - before * full_turn / start.omega * scene.disturbance_frequency;
    there.start_position = start.position;
    there.start_velocity = start.velocity;
    return ImpactModel<double>(there, summed_rebounds * scene.counting_limit);
  };
  std::vector<LaneOutcome> outcomes = run_in_lanes(starts.size(), model_at, observer_at);
  for (const LaneOutcome& outcome : outcomes) {
    if (outcome.failure) std::rethrow_exception(outcome.failure);
  }
  return outcomes;
}

struct Nobody : Observer {
  static constexpr bool hears_impacts_alone = true;
};

/// What happens in the last turns of a window.
class LastTurns : public Observer {
 public:
  LastTurns(const Scene& scene, int before, int turns)
      : scene_(scene),
        turn_(full_turn / scene.omega),
        start_(turn_ * before),
        turns_(static_cast<std::size_t>(turns)) {}

  void impact(double time, Wall wall, double speed) {
    if (time < start_) return;
    const auto k = static_cast<std::size_t>((time - start_) / turn_);
    if (k >= turns_.size()) return;
    turns_[k].fastest = std::max(turns_[k].fastest, speed);
    turns_[k].energy += impact_loss(scene_, wall) * speed * speed;
    if (is_counted(speed, scene_.counting_limit)) ++turns_[k].collisions;
  }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (path.harmonics != 0) return;
    for (std::size_t k = 0; k < turns_.size(); ++k) {
      const double from = start_ + turn_ * static_cast<double>(k);
      const double within = std::min(time + duration, from + turn_) - std::max(time, from);
      if (within > 0) turns_[k].share_at_rest += within / turn_;
    }
  }

  const std::vector<ObservedTurn>& turns() const { return turns_; }

 private:
  const Scene& scene_;
  double turn_, start_;  // [s]
  std::vector<ObservedTurn> turns_;
};

}  // namespace

void pass(const Scene& scene, std::vector<TurnStart>& starts, int before) {
  if (before == 0) return;
  Nobody nobody;
  const auto outcomes =
      fly(scene, starts, before, before, [&](std::size_t) -> Nobody& { return nobody; });
  for (std::size_t k = 0; k < starts.size(); ++k) {
    starts[k].position = outcomes[k].end.position;
    starts[k].velocity = outcomes[k].end.velocity;
  }
}

std::vector<DisturbedTurn> turns_from(const Scene& scene, std::span<const TurnStart> starts) {
  std::vector<CollectedImpacts> impacts(starts.size());
  const double slowest = std::exp(lowest_margin) * scene.counting_limit;
  for (CollectedImpacts& each : impacts) each.slowest = slowest;
  const auto outcomes =
      fly(scene, starts, 1, 0, [&](std::size_t k) -> CollectedImpacts& { return impacts[k]; });
  std::vector<DisturbedTurn> turns;
  turns.reserve(starts.size());
  for (std::size_t k = 0; k < starts.size(); ++k) {
    turns.push_back(
        turn_with(std::move(impacts[k].all), starts[k], scene.counting_limit, outcomes[k].end));
  }
  return turns;
}

std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before) {
  std::vector<TurnStart> starts;
  for (const double phase : phases) {
    starts.push_back({scene.omega, phase, scene.start_position, scene.start_velocity});
  }
  pass(scene, starts, before);
  return turns_from(scene, starts);
}

std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns) {
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(before + turns)};
  std::vector<LastTurns> last(phases.size(), LastTurns(scene, before, turns));
  const auto outcomes = run_in_lanes(
      phases.size(),
      [&](std::size_t k) {
        there.disturbance_phase = phases[k];
        return ImpactModel<double>(there);
      },
      [&](std::size_t k) -> LastTurns& { return last[k]; });
  std::vector<ObservedTurn> all;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    all.insert(all.end(), last[k].turns().begin(), last[k].turns().end());
  }
  return all;
}

void begin_turns_at_rest(Scene& scene) {
  const auto plate = AppliedForces<double>(scene).flight(0, 0, 0).harmonic[0];
  scene.phase += std::numbers::pi / 2 - std::atan2(plate.sine, plate.cosine);
}

}  // namespace ricochet::carrier_track::inline regimes
