#include "problems/carrier_track/regimes/orbit_map.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "problems/carrier_track/models/simulate.h"
#include "problems/carrier_track/scene/lifted.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track::inline regimes {
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
