#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {

inline Integrator find_integrator(const std::string& name) {
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.name == name) return integrator;
  }
  throw std::invalid_argument("no integrator " + name);
}

/// Those whose control is `control`.
inline std::vector<Integrator> integrators_by(const std::string& control) {
  std::vector<Integrator> chosen;
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == control) chosen.push_back(integrator);
  }
  return chosen;
}

/// A finished run.
inline Outcome run(const Integrator& integrator, const Scene& scene, double control) {
  const Outcome outcome = integrator.run(scene, control);
  EXPECT_TRUE(outcome.finished) << integrator.name << ": " << outcome.failure;
  EXPECT_TRUE(outcome.failure.empty()) << integrator.name << ": " << outcome.failure;
  return outcome;
}

inline Outcome reference(const Scene& scene) {
  return run(find_integrator("event-driven"), scene, 0.0);
}

inline Scene paper_scene(const std::string& id, double omega) {
  Scene scene = scene_of(find_case(id), exploratory_scene());
  scene.omega = omega;
  return scene;
}

/// A ball dropped from 50 m on a floor at 0: its impacts are a geometric series.
inline Scene bouncing_ball() {
  Scene scene;
  scene.wall_upper = infinity;
  scene.start_position = 50.0;
  scene.pull = 9.8;
  scene.restitution_lower = 0.8;
  scene.window = Seconds{40.0};
  return scene;
}

/// Time [s] of impact k = 0, 1, ... of the bouncing ball.
inline double bounce_time(std::size_t k) {
  const double e = 0.8;
  return std::sqrt(2 * 50.0 / 9.8) * (1 + e - 2 * std::pow(e, static_cast<double>(k) + 1)) /
         (1 - e);
}

/// A block that slides to and fro, 1 m from each wall, with friction 0.25 x 2 N on 0.8 kg.
inline Scene block() {
  Scene scene;
  scene.wall_lower = -1.0;
  scene.wall_upper = 1.0;
  scene.start_position = 0.0;
  scene.mass = 0.8;
  scene.friction = 0.25;
  scene.normal_force = 2.0;
  return scene;
}
inline constexpr double block_friction = 0.25 * 2.0 / 0.8;  // [m/s^2]

/// A free mass between two shaken walls, e = 0.5, on its way to the stable symmetric orbit with two
/// impacts a period; the gap has 5 amplitudes.
inline Scene shaken_gap() {
  const double amplitude = 2e-4;                         // [m]
  const double frequency = 2 * std::numbers::pi * 10.0;  // [rad/s]
  Scene scene;
  scene.wall_upper = 5 * amplitude;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.disturbance = amplitude * frequency * frequency;
  scene.disturbance_frequency = frequency;
  scene.start_position = 0.5e-3;
  scene.start_velocity = 0.03;
  scene.window = Seconds{2.0};
  return scene;
}

}  // namespace ricochet::carrier_track
