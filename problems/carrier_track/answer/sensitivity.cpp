#include "problems/carrier_track/answer/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "problems/carrier_track/answer/long_run.h"
#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "ricochet/random.h"
#include "ricochet/threshold.h"
#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline answer {
namespace {

/// Calls use(key, member...) for every constant that may deviate in manufacture.
template <class Use>
class EachConstant {
 public:
  EachConstant(std::string prefix, const Use& use) : prefix_(std::move(prefix)), use_(use) {}

  template <class T>
  void operator()(const Field& field, T&& member) const {
    if constexpr (std::is_same_v<std::remove_cvref_t<T>, double>) {
      if (field.perturbation == Perturbation::relative)
        use_(prefix_ + std::string(field.key), member);
    }
  }
  void operator()(const Field& field, Walls<double> walls) const {
    if (field.perturbation != Perturbation::restitution) return;
    use_(prefix_ + std::string(field.key), walls.lower);
    use_(prefix_ + std::string(field.key), walls.upper);
    walls.lower = std::min(1.0, walls.lower);
    walls.upper = std::min(1.0, walls.upper);
  }
  void operator()(const Field& field, std::optional<double>& member) const {
    if (member) (*this)(field, *member);
  }
  template <class Knots>
  void operator()(const Field&, PlateSpeed<double, Knots>) const {}

 private:
  std::string prefix_;
  const Use& use_;
};

/// Calls use(key, clearance) for the walls of x or of y, and moves the upper wall to the result.
template <class Owner, class Use>
void visit_clearance(Owner& owner, const std::string& key, const Use& use) {
  if (!std::isfinite(owner.wall_upper)) return;
  double clearance = owner.wall_upper - owner.wall_lower;
  const double share = (owner.start_position - owner.wall_lower) / clearance;
  const double before = clearance;
  use(key, clearance);
  if (clearance == before) return;  // keeps all digits
  owner.wall_upper = owner.wall_lower + clearance;
  owner.start_position = std::min(owner.wall_upper, owner.wall_lower + share * clearance);
}

template <class Use>
void visit_constants(Scene& scene, const Use& use) {
  visit_scene_fields(EachConstant("", use), scene);
  if (scene.fidelity == Fidelity::compliant || scene.fidelity == Fidelity::automatic) {
    visit_model_fields(EachConstant("", use), scene);
  }
  visit_clearance(scene, "clearance", use);
  if (!scene.across) return;
  visit_across_fields(EachConstant("across.", use), *scene.across);
  visit_clearance(*scene.across, "across.clearance", use);
}

/// The sum over the walls of what has a value for each, of which one may be 0.
double value_of(Scene scene, const std::string& wanted) {
  double value = 0;
  visit_constants(scene, [&](const std::string& key, double x) {
    if (key == wanted) value += x;
  });
  return value;
}

/// The speed that best divides the speeds low, low ratio, low ratio^2, ... by the limit.
std::optional<double> divide(const Scene& scene, const Limit& limit, double low, double ratio,
                             int speeds) {
  std::vector<double> at;
  for (int k = 0; k < speeds; ++k) at.push_back(low * std::pow(ratio, k));
  SpeedScan scan{1, {}};
  for (const double measure : measured_at(scene, limit.measure, at)) {
    scan.counts.push_back(measure > limit.at_most ? 1 : 0);
  }
  const auto place = best_split(scan, 0.5).speed;  // k + 1.5 between the speeds k and k + 1
  return place ? std::optional(low * std::pow(ratio, *place - 1)) : std::nullopt;
}

}  // namespace

void check_near(const Scene& scene, double omega, int machines) {
  check(scene, "scene");
  if (!(omega > 0 && omega <= fastest_frequency)) {
    throw InputError(
        fmt::format("omega = {}: must be > 0 and at most {} [rad/s]", omega, fastest_frequency));
  }
  if (machines < 1) throw InputError(fmt::format("machines = {}: must be >= 1", machines));
}

std::vector<std::string> constants_of(const Scene& scene) {
  std::vector<std::string> keys;
  Scene copy = scene;
  visit_constants(copy, [&](const std::string& key, double x) {
    if (x != 0 && (keys.empty() || keys.back() != key)) keys.push_back(key);
  });
  return keys;
}

Scene scaled(Scene scene, const std::string& wanted, double factor) {
  visit_constants(scene, [&](const std::string& key, double& x) {
    if (key == wanted) x *= factor;
  });
  return scene;
}

std::optional<double> divide_near(const Scene& scene, const Limit& limit, double omega) {
  if (is_of_the_long_run(scene, limit)) {
    const double highest = omega * 1.5;
    const auto speed = quiet_up_to(scene, limit.at_most, {omega / 1.5, highest});
    return speed && *speed < highest ? speed : std::nullopt;
  }
  constexpr double coarse = 1.002;
  const int speeds = 1 + static_cast<int>(std::lround(std::log(2.25) / std::log(coarse)));
  const auto first = divide(scene, limit, omega / 1.5, coarse, speeds);
  if (!first) return std::nullopt;
  constexpr int fine = 100;
  const double ratio = std::pow(coarse, 2.0 / fine);
  return divide(scene, limit, *first / coarse, ratio, fine + 1).value_or(*first);
}

std::vector<Sensitivity> sensitivities(const Scene& scene, const Limit& limit, double omega) {
  check_near(scene, omega);
  constexpr double percent = 0.01;
  const std::vector<std::string> keys = constants_of(scene);
  std::vector<std::optional<double>> divides(2 * keys.size());
  in_parallel("sensitivities", divides.size(), [&](std::size_t i) {
    const double factor = i % 2 == 0 ? 1 - percent : 1 + percent;
    divides[i] = divide_near(scaled(scene, keys[i / 2], factor), limit, omega);
  });
  std::vector<Sensitivity> result;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto& less = divides[2 * k];
    const auto& more = divides[2 * k + 1];
    if (!less || !more) continue;
    const double change = std::log(value_of(scaled(scene, keys[k], 1 + percent), keys[k]) /
                                   value_of(scaled(scene, keys[k], 1 - percent), keys[k]));
    result.push_back({keys[k], std::log(*more / *less) / change});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::abs(a.percent) > std::abs(b.percent);
  });
  return result;
}

std::optional<ToleranceRange> divide_range(const std::vector<Scene>& machines, const Limit& limit,
                                           double omega) {
  std::vector<std::optional<double>> divides(machines.size());
  in_parallel("machines within the tolerance", machines.size(),
              [&](std::size_t i) { divides[i] = divide_near(machines[i], limit, omega); });
  const int all = static_cast<int>(machines.size());
  ToleranceRange range{std::numeric_limits<double>::infinity(), 0, all, 0};
  for (const std::optional<double>& speed : divides) {
    if (!speed) {
      ++range.without;
      continue;
    }
    range.lowest = std::min(range.lowest, *speed);
    range.highest = std::max(range.highest, *speed);
  }
  return range.without < all ? std::optional(range) : std::nullopt;
}

std::optional<ToleranceRange> tolerance_range(const Scene& scene, const Limit& limit, double omega,
                                              double tolerance, int machines, std::uint64_t seed) {
  check_near(scene, omega, machines);
  if (!(tolerance >= 0 && tolerance <= 0.5)) {
    throw InputError(fmt::format("tolerance = {}: must be within 0..0.5", tolerance));
  }
  const std::vector<std::string> keys = constants_of(scene);
  Random random(seed);
  std::vector<Scene> drawn;
  for (int i = 0; i < machines; ++i) {
    Scene& machine = drawn.emplace_back(scene);
    for (const std::string& key : keys) {
      machine = scaled(std::move(machine), key, 1 + tolerance * (2 * uniform(random) - 1));
    }
  }
  return divide_range(drawn, limit, omega);
}

}  // namespace ricochet::carrier_track::inline answer
