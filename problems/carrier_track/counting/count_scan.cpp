#include "problems/carrier_track/counting/count_scan.h"

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

namespace {

/// Sums the objective in the order of the impacts; the count without its logarithm.
struct ObjectiveSum : Observer {
  static constexpr bool hears_impacts_alone = true;

  const Scene* scene = nullptr;
  double smoothing = 0;
  double sum = 0;

  void impact(double time, Wall wall, double speed) {
    auto add = [this](double z, double left) { sum += weight(z, left, smoothing); };
    if (smoothing != 0) Features<double, decltype(add)>(*scene, add).impact(time, wall, speed);
    if (smoothing == 0 && is_counted(speed, scene->counting_limit)) sum += 1;
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
  std::vector<double> results(scenes.size());
  if (!std::all_of(scenes.begin(), scenes.end(), suits_lanes)) {
    for (std::size_t k = 0; k < scenes.size(); ++k) results[k] = objective(scenes[k], smoothing);
    return results;
  }
  // Lanes wait for the body with the most rebounds, so similar restitutions become neighbours.
  std::vector<ObjectiveSum> observers;
  for (const Scene& scene : scenes) observers.push_back({{}, &scene, smoothing});
  std::stable_sort(observers.begin(), observers.end(), [](const auto& a, const auto& b) {
    return a.scene->restitution_lower < b.scene->restitution_lower;
  });
  run_all([&](std::size_t k) -> const Scene& { return *observers[k].scene; }, observers);
  for (const auto& o : observers) results[static_cast<std::size_t>(o.scene - &scenes[0])] = o.sum;
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

namespace {

using Jet = ceres::Jet<double, 1>;

/// Impacts with at least the first margin are recorded; those with at least the second must have a
/// counterpart. An impact slower than a third of the limit does not count at nearby speeds.
constexpr double followed = -3;
constexpr double watched = -1;
/// Turning points nearer to a wall than this share of the clearance must have a counterpart.
constexpr double near_wall = 0.1;
/// Two features are the same if the difference of their times, as a share of the window, agrees
/// with the prediction of the derivatives within this.
constexpr double same_time = 0.01;
/// The motion is simulated for this multiple of the window, to see features that enter at its end.
constexpr double longer = 1.01;
/// A number must be this many times further from zero than the error of the derivatives' prediction
/// at the other speed. A cubic through both ends deviates from their chord by less than a seventh
/// of that error.
constexpr double safety = 1;

}  // namespace

class MotionSketch::Watch : public Observer {
 public:
  Watch(MotionSketch& sketch, const BasicScene<Jet>& scene)
      : sketch_(sketch), scene_(scene), duration_(duration_of(scene)) {}

  void impact(const Jet& time, Wall wall, const Jet& speed) {
    const bool within = time.a <= duration_.a;
    sketch_.count_ += within && is_counted(speed.a, scene_.counting_limit.a) ? 1 : 0;
    if (!(speed.a > 0)) return;
    const Jet margin = impact_margin(speed, scene_.counting_limit);
    if (margin.a < followed) return;
    add(wall == Wall::lower ? Kind::lower_impact : Kind::upper_impact, time, margin);
  }

  void turn(const Jet& time, const Jet& position, Wall ahead) {
    const bool upper = ahead == Wall::upper;
    const Jet missed = (upper ? scene_.wall_upper - position : position - scene_.wall_lower) /
                       (scene_.wall_upper - scene_.wall_lower);
    if (!(missed.a > 0 && missed.a < 2 * near_wall)) return;
    add(upper ? Kind::upper_graze : Kind::lower_graze, time, missed);
  }

 private:
  void add(Kind kind, const Jet& time, const Jet& margin) {
    const Jet share = time / duration_;
    sketch_.features_.push_back({kind, {share.a, share.v[0]}, {margin.a, margin.v[0]}});
  }

  MotionSketch& sketch_;
  const BasicScene<Jet>& scene_;
  Jet duration_;  // of the window that counts
};

MotionSketch::MotionSketch(const Scene& scene, double omega) : omega_(omega) {
  BasicScene<Jet> there = at_speed(lifted<Jet>(scene), Jet(omega, 0));
  Watch watch(*this, there);
  std::visit([](auto& window) { window.count *= longer; }, there.window);
  simulate(there, watch);
}

/// Returns true if a number with these derivatives keeps its sign between two speeds a step apart.
bool MotionSketch::keeps_sign(const Sloped& a, const Sloped& b, double step) {
  const double rise = b.value - a.value;
  const double missed = std::abs(rise - step * a.slope) + std::abs(rise - step * b.slope);
  return a.value * b.value > 0 && std::min(std::abs(a.value), std::abs(b.value)) > safety * missed;
}

const MotionSketch::Feature* MotionSketch::counterpart(const Feature& feature, double step) const {
  const double share = feature.share.value + step * feature.share.slope;
  const Feature* best = nullptr;
  double nearest = same_time;
  const auto sooner = [](const Feature& f, double than) { return f.share.value < than; };
  for (auto other = std::lower_bound(features_.begin(), features_.end(), share - nearest, sooner);
       other != features_.end() && other->share.value < share + nearest; ++other) {
    if (other->kind != feature.kind) continue;
    nearest = std::abs(other->share.value - share);
    best = &*other;
  }
  return best;
}

bool MotionSketch::joins_by_features_of(const MotionSketch& one, const MotionSketch& other,
                                        bool forwards) const {
  const double step = other.omega_ - one.omega_;
  return std::all_of(one.features_.begin(), one.features_.end(), [&](const Feature& f) {
    const bool graze = f.kind == Kind::lower_graze || f.kind == Kind::upper_graze;
    if (graze ? f.margin.value > near_wall : f.margin.value < watched) return true;
    const Feature* match = other.counterpart(f, step);
    if (match == nullptr) return false;
    const Feature& a = forwards ? f : *match;
    const Feature& b = forwards ? *match : f;
    if (!keeps_sign(a.margin, b.margin, std::abs(step))) return false;
    if (graze || f.margin.value < 0) return true;
    return keeps_sign({1 - a.share.value, -a.share.slope}, {1 - b.share.value, -b.share.slope},
                      std::abs(step));
  });
}

bool MotionSketch::joins(const MotionSketch& faster) const {
  return count_ == faster.count_ && joins_by_features_of(*this, faster, true) &&
         joins_by_features_of(faster, *this, false);
}

}  // namespace ricochet::carrier_track::inline counting
