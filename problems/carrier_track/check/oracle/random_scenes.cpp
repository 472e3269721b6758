#include "problems/carrier_track/check/oracle/random_scenes.h"

#include <cmath>
#include <limits>

namespace ricochet::carrier_track::inline oracle {

Scene RandomScenes::next() {
  Scene scene;
  scene.mass = within(0.5, 2.0);
  scene.wall_lower = chance(0.5) ? 0.0 : within(-2e-3, 1e-3);
  const double gap = log_within(0.2e-3, 5e-3);
  scene.wall_upper = scene.wall_lower + gap;
  scene.restitution_lower = restitution();
  scene.restitution_upper = chance(0.5) ? scene.restitution_lower : restitution();
  scene.friction = chance(0.3) ? 0.0 : within(0.0, 0.5);
  scene.normal_force = within(0.0, 3.0);
  scene.pull = chance(0.2) ? 0.0 : within(-1.5, 1.5);
  scene.pull_rotates = chance(0.3);
  scene.omega = log_within(0.5, 20.0);
  scene.centrifugal = static_cast<Centrifugal>(random_() % 3);
  const double square = scene.omega * scene.omega;
  scene.centrifugal_mass_radius = chance(0.2) ? 0.0 : within(0.0, 2.0) / square;
  scene.slider_mass_radius = chance(0.5) ? 0.0 : within(0.0, 1.0) / square;
  scene.phase = within(-4.0, 4.0);
  scene.disturbance = chance(0.4) ? 0.0 : within(-1.0, 1.0);
  scene.disturbance_frequency = log_within(0.3, 40.0);
  scene.start_position = scene.wall_lower + gap * share_of_gap();
  scene.start_velocity = chance(0.3) ? 0.0 : within(-0.1, 0.1);
  if (chance(0.4)) {
    scene.window = Seconds{within(0.3, 2.0)};
  } else {
    scene.window = Revolutions{within(0.3, 2.0) * scene.omega / 6.28};
  }
  if (chance(0.1)) scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.counting_limit = log_within(1e-3, 2e-2);
  const std::uint64_t draw = phases_();
  if (draw % 2 == 0) scene.pull_phase = angle();
  if (draw / 2 % 2 == 0) scene.disturbance_phase = angle();
  scene.contact_friction = draw / 4 % 5 == 0;
  return scene;
}

Scene RandomScenes::next_planar() {
  Scene scene = next();
  scene.fidelity = Fidelity::planar;
  scene.contact_friction = false;
  Across<double>& y = scene.across.emplace();
  y.pull = scene.pull_rotates || chance(0.2) ? 0.0 : within(-1.5, 1.5);
  y.wall_lower = chance(0.5) ? 0.0 : within(-2e-3, 1e-3);
  const double gap = log_within(0.2e-3, 5e-3);
  y.wall_upper = y.wall_lower + gap;
  y.restitution_lower = restitution();
  y.restitution_upper = chance(0.5) ? y.restitution_lower : restitution();
  y.start_position = y.wall_lower + gap * share_of_gap();
  y.start_velocity = chance(0.3) ? 0.0 : within(-0.1, 0.1);
  if (chance(0.1)) y.wall_upper = std::numeric_limits<double>::infinity();
  return scene;
}

double RandomScenes::within(double a, double b) {
  return a + (b - a) * static_cast<double>(random_() >> 11) * 0x1p-53;
}

double RandomScenes::angle() {
  return -4 + 8 * static_cast<double>(phases_() >> 11) * 0x1p-53;
}

double RandomScenes::log_within(double a, double b) {
  return a * std::pow(b / a, within(0, 1));
}

bool RandomScenes::chance(double probability) {
  return within(0, 1) < probability;
}

int RandomScenes::below(int limit) {
  return static_cast<int>(random_() % static_cast<std::uint64_t>(limit));
}

double RandomScenes::restitution() {
  switch (random_() % 6) {
    case 0:
      return 0.0;
    case 1:
      return 0.1;
    case 2:
      return 0.9;
    case 3:
      return 1.0;
    default:
      return within(0.0, 1.0);
  }
}

double RandomScenes::share_of_gap() {
  switch (random_() % 6) {
    case 0:
      return 0.0;
    case 1:
      return 1.0;
    default:
      return within(0.0, 1.0);
  }
}

}  // namespace ricochet::carrier_track::inline oracle
