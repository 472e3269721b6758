#include "problems/carrier_track/regimes/followed_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/error.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

/// Impacts this much slower than the counting limit, in logarithms, matter to no border nearby.
constexpr double far_below = 3;

/// A series of impacts ends in a rest if its last is this slow, relative to the counting limit.
constexpr double end_of_series = 1e-3;

constexpr double near_speeds = 0.2;  // of the logarithm

/// The impacts of a period that count.
std::vector<Impact> collisions_of(const SteadyMotion& motion) {
  std::vector<Impact> found;
  for (const Impact& impact : motion.impacts) {
    if (is_counted(impact.speed, motion.orbit.counting_limit)) found.push_back(impact);
  }
  return found;
}

}  // namespace

std::optional<std::size_t> place_of_rank(const SteadyMotion& motion, int rank) {
  const std::vector<Impact>& impacts = motion.impacts;
  if (rank < 1 || rank > static_cast<int>(impacts.size())) return std::nullopt;
  std::vector<std::size_t> places(impacts.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  const auto nth = places.begin() + (rank - 1);
  std::nth_element(places.begin(), nth, places.end(), [&](std::size_t a, std::size_t b) {
    return impacts[a].speed > impacts[b].speed;
  });
  return *nth;
}

Signature signature_of(const SteadyMotion& motion) {
  const bool settled =
      motion.settled && (motion.rest != Rest::never || motion.impacts.empty() || motion.stable());
  if (!settled) return {0, 0, false, false, true};  // whatever it does, it does not keep doing so
  return {motion.turns, motion.collisions, true,
          motion.rest == Rest::in_the_gap || motion.rest == Rest::on_a_wall,
          motion.rest != Rest::always};
}

double rank_margin(const SteadyMotion& motion, int rank) {
  constexpr double least = -6;
  const std::optional<std::size_t> place = place_of_rank(motion, rank);
  if (!place) return least;
  const double speed = motion.impacts[*place].speed;
  return std::max(std::log(speed / motion.orbit.counting_limit), least);
}

bool is_near(const SteadyMotion& a, const SteadyMotion& b) {
  const std::vector<Impact> first = collisions_of(a);
  const std::vector<Impact> second = collisions_of(b);
  const std::size_t size = first.size();
  if (size != second.size()) return false;
  const auto alike = [](const Impact& x, const Impact& y) {
    return x.wall == y.wall && std::abs(std::log(x.speed / y.speed)) <= near_speeds;
  };
  // Each may start at another of its rests.
  for (std::size_t k = 0; k < size; ++k) {
    check_time_limit();
    std::size_t i = 0;
    while (i < size && alike(first[i], second[(i + k) % size])) ++i;
    if (i == size) return true;
  }
  return size == 0;
}

Margins margins_of(const SteadyMotion& motion) {
  Margins margins;
  if (!motion.settled || motion.rest == Rest::always || motion.impacts.empty()) return margins;
  const OrbitMap map = map_of(motion.orbit, motion.rest);
  const AlongOrbit along(map, motion.rest);
  const double limit = motion.orbit.counting_limit;
  std::size_t series = 0;
  std::size_t place = 0;
  const std::size_t size = std::min(motion.impacts.size(), map.speeds.size());
  for (std::size_t i = 0; i < size; ++i) {
    const Impact& impact = motion.impacts[i];
    const double value = std::log(impact.speed / limit);
    if (value > -far_below) {
      const auto& speed = map.speeds[i];
      margins.known.push_back(
          {value, along(speed, OrbitMap::omega_index) / speed.a * motion.omega(), series, place});
    }
    ++place;
    if (i + 1 == size || motion.impacts[i + 1].wall != impact.wall) {
      const bool rests = impact.speed < end_of_series * limit;
      margins.structure.push_back(2 * (rests ? 0 : place) + (impact.wall == Wall::upper ? 1 : 0));
      ++series;
      place = 0;
    }
  }
  return margins;
}

LongRun long_run_of(const SteadyMotion& motion) {
  return {motion.orbit, motion.collisions_per_turn(), motion.energy_per_turn(),
          motion.fastest_impact(), motion.share_at_rest};
}

namespace {

using Number = OrbitMap::Number;

/// Calls use(member) for every number of the scene that the constant of that key sets; returns
/// whether the key is known.
template <class Scalar, class Use>
bool visit_constant(BasicScene<Scalar>& scene, const std::string& key, const Use& use) {
  if (key == "restitution") {
    use(scene.restitution_lower);
    use(scene.restitution_upper);
    return true;
  }
  const std::array<std::pair<const char*, Scalar*>, 13> members = {{
      {"mass", &scene.mass},
      {"clearance", &scene.wall_upper},
      {"restitution_lower", &scene.restitution_lower},
      {"restitution_upper", &scene.restitution_upper},
      {"friction", &scene.friction},
      {"normal_force", &scene.normal_force},
      {"pull", &scene.pull},
      {"pull_phase", &scene.pull_phase},
      {"centrifugal_mass_radius", &scene.centrifugal_mass_radius},
      {"slider_mass_radius", &scene.slider_mass_radius},
      {"disturbance", &scene.disturbance},
      {"disturbance_frequency", &scene.disturbance_frequency},
      {"counting_limit", &scene.counting_limit},
  }};
  for (const auto& [name, member] : members) {
    if (key == name) {
      use(*member);
      return true;
    }
  }
  return false;
}

class MapWatch final : public DualObserver<Number> {
 public:
  MapWatch(const BasicScene<Number>& scene, OrbitMap& map) : scene_(scene), map_(map) {}

  void impact(const Number& /*time*/, Wall wall, const Number& speed) override {
    if (!(speed.a > 0)) return;
    map_.speeds.push_back(speed);
    map_.walls.push_back(wall);
  }
  void peak(const Number& /*time*/, const Number& /*position*/) override {}
  void turn(const Number& /*time*/, const Number& position, Wall ahead) override {
    map_.misses.push_back(ahead == Wall::upper ? scene_.wall_upper - position
                                               : position - scene_.wall_lower);
  }
  void hops(const Number& /*time*/, Wall /*wall*/) override {}

 private:
  const BasicScene<Number>& scene_;
  OrbitMap& map_;
};

}  // namespace

std::vector<std::string> continuation_constants() {
  return {"mass",
          "clearance",
          "restitution",
          "restitution_lower",
          "restitution_upper",
          "friction",
          "normal_force",
          "pull",
          "pull_phase",
          "centrifugal_mass_radius",
          "slider_mass_radius",
          "disturbance",
          "disturbance_frequency",
          "counting_limit"};
}

void set_constant(Scene& scene, const std::string& key, double to) {
  const double value = key == "clearance" ? scene.wall_lower + to : to;
  if (!visit_constant(scene, key, [&](double& member) { member = value; })) {
    throw InputError(fmt::format("{}: a border can be followed over: {}", key,
                                 fmt::join(continuation_constants(), ", ")));
  }
}

double constant_named(const Scene& scene, const std::string& key) {
  Scene copy = scene;
  double result = 0;
  if (!visit_constant(copy, key, [&](double& member) { result = member; }))
    set_constant(copy, key, 0);
  return key == "clearance" ? result - scene.wall_lower : result;
}

void vary_constant(BasicScene<Number>& scene, const std::string& key, int index) {
  visit_constant(scene, key, [&](Number& member) { member.v[index] = 1; });
}

OrbitMap map_of(const Scene& orbit, Rest rest, std::span<const std::string> constants) {
  BasicScene<Number> scene = lifted<Number>(orbit);
  scene.omega.v[OrbitMap::omega_index] = 1;
  int index = OrbitMap::constant_index;
  for (const std::string& key : constants) {
    vary_constant(scene, key, index++);
  }
  if (rest == Rest::on_a_wall) {
    scene.start_position =
        orbit.start_position == orbit.wall_upper ? scene.wall_upper : scene.wall_lower;
  } else {
    scene.start_position.v[OrbitMap::position_index] = 1;
  }
  if (rest == Rest::never) scene.start_velocity.v[OrbitMap::velocity_index] = 1;
  OrbitMap map;
  MapWatch watch(scene, map);
  const End<Number> end = simulate_dual<AppliedForces<Number>>(scene, watch);
  map.position = end.position;
  map.velocity = end.velocity;
  return map;
}

AlongOrbit::AlongOrbit(const OrbitMap& map, Rest rest) {
  const auto& x = map.position.v;
  const auto& v = map.velocity.v;
  for (int k = 0; k < 3; ++k) {
    const int index = OrbitMap::omega_index + k;
    if (rest == Rest::in_the_gap) {
      position_[k] = x[index] / (1 - x[0]);
    } else if (rest == Rest::never) {
      const double determinant = (1 - x[0]) * (1 - v[1]) - x[1] * v[0];
      position_[k] = ((1 - v[1]) * x[index] + x[1] * v[index]) / determinant;
      velocity_[k] = (v[0] * x[index] + (1 - x[0]) * v[index]) / determinant;
    }
  }
}

double AlongOrbit::operator()(const Number& number, int index) const {
  const int k = index - OrbitMap::omega_index;
  return number.v[index] + number.v[0] * position_[k] + number.v[1] * velocity_[k];
}

MapInvariants invariants_of(const OrbitMap& map, Rest rest) {
  const auto& x = map.position.v;
  const auto& v = map.velocity.v;
  if (rest == Rest::never) return {x[0] + v[1], x[0] * v[1] - x[1] * v[0]};
  if (rest == Rest::in_the_gap) return {x[0], 0};
  return {0, 0};
}

}  // namespace ricochet::carrier_track::inline regimes
