#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"
#include "tests/support/numbers.h"

/// Scenes for tests, each in one expression: with(Scene{}, set::mass(1.3), set::restitution(0.8)).
namespace ricochet::carrier_track {

/// The scene after the changes, one after the other.
template <class... Changes>
Scene with(Scene scene, const Changes&... changes) {
  (changes(scene), ...);
  return scene;
}

/// Changes of a scene, each named after the field that it sets, in the field's unit.
namespace set {

template <auto member>
struct Field {
  template <class Value>
  auto operator()(Value value) const {
    return [value](Scene& scene) { scene.*member = value; };
  }
};

inline constexpr Field<&Scene::mass> mass;
inline constexpr Field<&Scene::wall_lower> wall_lower;
inline constexpr Field<&Scene::wall_upper> wall_upper;
inline constexpr Field<&Scene::restitution_lower> restitution_lower;
inline constexpr Field<&Scene::restitution_upper> restitution_upper;
inline constexpr Field<&Scene::friction> friction;
inline constexpr Field<&Scene::normal_force> normal_force;
inline constexpr Field<&Scene::contact_friction> contact_friction;
inline constexpr Field<&Scene::pull> pull;
inline constexpr Field<&Scene::pull_rotates> pull_rotates;
inline constexpr Field<&Scene::pull_phase> pull_phase;
inline constexpr Field<&Scene::centrifugal> centrifugal;
inline constexpr Field<&Scene::centrifugal_mass_radius> centrifugal_mass_radius;
inline constexpr Field<&Scene::slider_mass_radius> slider_mass_radius;
inline constexpr Field<&Scene::phase> phase;
inline constexpr Field<&Scene::disturbance> disturbance;
inline constexpr Field<&Scene::disturbance_frequency> disturbance_frequency;
inline constexpr Field<&Scene::disturbance_phase> disturbance_phase;
inline constexpr Field<&Scene::start_position> start_position;
inline constexpr Field<&Scene::start_velocity> start_velocity;
inline constexpr Field<&Scene::omega> omega;
inline constexpr Field<&Scene::profile> profile;
inline constexpr Field<&Scene::rule> rule;
inline constexpr Field<&Scene::counting_limit> counting_limit;
inline constexpr Field<&Scene::peak_high> peak_high;
inline constexpr Field<&Scene::peak_low> peak_low;
inline constexpr Field<&Scene::fidelity> fidelity;
inline constexpr Field<&Scene::contact_law> contact_law;
inline constexpr Field<&Scene::stiffness> stiffness;
inline constexpr Field<&Scene::contact_exponent> contact_exponent;
inline constexpr Field<&Scene::contact_speed> contact_speed;
inline constexpr Field<&Scene::across> across;

/// Of both walls.
inline auto restitution(double value) {
  return [value](Scene& scene) { scene.restitution_lower = scene.restitution_upper = value; };
}
inline auto walls(double lower, double upper) {
  return [=](Scene& scene) { scene.wall_lower = lower, scene.wall_upper = upper; };
}
inline auto start(double position, double velocity) {
  return [=](Scene& scene) { scene.start_position = position, scene.start_velocity = velocity; };
}
inline auto seconds(double count) {
  return [count](Scene& scene) { scene.window = Seconds{count}; };
}
inline auto revolutions(double count) {
  return [count](Scene& scene) { scene.window = Revolutions{count}; };
}
/// A second direction, in the planar model.
inline auto planar(const Across<double>& across = {}) {
  return [across](Scene& scene) { scene.fidelity = Fidelity::planar, scene.across = across; };
}

}  // namespace set

/// A case of the paper on the default machine, e.g. "C1".
inline Scene case_scene(const std::string& id) {
  return scene_of(find_case(id), default_machine());
}

/// The second case in the planar model, which has no regimes: nothing couples its directions.
inline Scene planar_second_case() {
  const Scene scene = case_scene("C2");
  return with(scene, set::restitution(lower_restitution(scene)), set::contact_friction(false),
              set::planar());
}

/// The constants that an exploratory study fitted to the paper: a lively scene that stays the same
/// when the default interpretation is fitted again.
inline Scene exploratory_scene() {
  return with(Scene{}, set::mass(1.2), set::wall_upper(1.04e-3), set::normal_force(1.670),
              set::pull(0.888), set::centrifugal_mass_radius(0.2043), set::phase(3.12),
              set::start(0.54 * 1.04e-3, -0.090), set::omega(3.0), set::revolutions(1.314),
              set::counting_limit(9.65e-3));
}

/// The machine of a case of the paper with these constants.
inline Machine exploratory_machine(const std::string& id) {
  return machine_of(find_case(id), exploratory_scene());
}

/// A ball that falls from `height` [m] on a floor at 0 without another wall above.
inline Scene falling_ball(double height, double gravity, double restitution) {
  return with(Scene{}, set::wall_upper(infinity), set::start(height, 0), set::pull(gravity),
              set::restitution(restitution));
}

struct Bounce {
  double time, speed;
};

/// The first impacts of a falling_ball in closed form, also under a friction [N].
inline std::vector<Bounce> bounces_of(double height, long double gravity, long double restitution,
                                      std::size_t number, double friction = 0) {
  const long double up = gravity + friction, down = gravity - friction;
  long double time = std::sqrt(2 * height / down), speed = down * time;
  std::vector<Bounce> bounces;
  while (bounces.size() < number) {
    bounces.push_back({static_cast<double>(time), static_cast<double>(speed)});
    const long double rebound = restitution * speed;
    time += rebound / up + rebound / std::sqrt(up * down);
    speed = rebound * std::sqrt(down / up);
  }
  return bounces;
}

}  // namespace ricochet::carrier_track
