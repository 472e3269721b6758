#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "ricochet/scene.h"

/// A ball on a table that shakes as A sin(omega t), in the table's frame: it can strike once in
/// every period. The closed forms are in units of the gravity.
namespace ricochet::carrier_track::shaken_table {

inline constexpr double gravity = 9.81;
inline constexpr double amplitude = 0.01;

/// The peak acceleration at which the orbit begins to exist.
inline double fold_strength(double e) {
  return std::numbers::pi * (1 - e) / (1 + e);
}

/// The peak acceleration at which its period doubles.
inline double flip_strength(double e) {
  return std::hypot(fold_strength(e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
}

/// The speed [rad/s] at which the table has that peak acceleration.
inline double speed_at(double strength) {
  return std::sqrt(strength * gravity / amplitude);
}

/// The ball on the stable orbit, leaving the table.
inline Scene on_orbit(double e, double strength) {
  Scene scene;
  scene.mass = 2;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.restitution_lower = scene.restitution_upper = e;
  scene.pull = scene.mass * gravity;
  scene.centrifugal_mass_radius = scene.mass * amplitude;
  scene.omega = speed_at(strength);
  scene.phase = std::acos(fold_strength(e) / strength) - std::numbers::pi / 2;
  scene.start_position = 0;
  scene.start_velocity = e / (1 + e) * gravity * 2 * std::numbers::pi / scene.omega;
  return scene;
}

}  // namespace ricochet::carrier_track::shaken_table
