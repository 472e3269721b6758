#include "problems/carrier_track/regimes/observed_turn.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <numbers>
#include <utility>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/models/impact_lanes.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

/// What happens in the last turns of a window.
class LastTurns : public Observer {
 public:
  LastTurns(const Scene& scene, double phase, int before, int turns)
      : scene_(scene), turn_(2 * std::numbers::pi / scene.omega), start_(turn_ * before) {
    for (int k = 0; k < turns; ++k) turns_.push_back({{phase, {}, {}, 0}, 0, 0});
  }

  void impact(double time, Wall wall, double speed) {
    ObservedTurn* observed = at(time);
    if (observed == nullptr || speed <= 0) return;
    observed->turn.speeds.push_back(speed);
    observed->energy += impact_loss(scene_, wall) * speed * speed;
    if (is_counted(speed, scene_.counting_limit)) ++observed->turn.collisions;
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

  std::vector<ObservedTurn> turns() {
    for (ObservedTurn& observed : turns_) {
      std::vector<double>& speeds = observed.turn.speeds;
      std::sort(speeds.begin(), speeds.end(), std::greater<>());
    }
    return turns_;
  }

 private:
  ObservedTurn* at(double time) {
    if (time < start_) return nullptr;
    const auto k = static_cast<std::size_t>((time - start_) / turn_);
    return k < turns_.size() ? &turns_[k] : nullptr;
  }

  const Scene& scene_;
  double turn_, start_;  // [s]
  std::vector<ObservedTurn> turns_;
};

}  // namespace

std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns) {
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(before + turns)};
  std::vector<LastTurns> last;
  for (const double phase : phases) last.emplace_back(scene, phase, before, turns);
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
    for (ObservedTurn& observed : last[k].turns()) all.push_back(std::move(observed));
  }
  return all;
}

}  // namespace ricochet::carrier_track::inline regimes
