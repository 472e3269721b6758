#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {

/// Draws numbers of a machine.
class MachineDraw {
 public:
  explicit MachineDraw(std::uint64_t seed) : random_(seed) {}

  double even(double low, double high) { return low + (high - low) * uniform(random_); }
  double even_logarithm(double low, double high) {
    return std::exp(even(std::log(low), std::log(high)));
  }
  bool in(double share) { return uniform(random_) < share; }

 private:
  Random random_;
};

/// A machine of any size and forces, without disturbance.
inline Scene random_machine(std::uint64_t seed) {
  MachineDraw draw(seed);
  Scene scene;
  scene.mass = draw.even_logarithm(0.3, 3);
  scene.wall_upper = draw.even_logarithm(2e-4, 5e-3);
  scene.restitution_lower = scene.restitution_upper = draw.even(0, 0.95);
  if (draw.in(0.3)) scene.restitution_upper = draw.even(0, 0.95);
  scene.friction = draw.in(0.15) ? 0 : draw.even(0.02, 0.5);
  scene.normal_force = draw.even_logarithm(1, 30);
  scene.contact_friction = draw.in(0.5);
  scene.pull = draw.in(0.2) ? 0 : draw.even_logarithm(0.005, 3) * (draw.in(0.2) ? -1 : 1);
  scene.centrifugal_mass_radius = draw.even_logarithm(0.02, 1);
  if (draw.in(0.3)) {
    scene.pull_rotates = true;
    scene.pull_phase = draw.even(-3, 3);
  }
  if (draw.in(0.3)) scene.slider_mass_radius = draw.even_logarithm(1e-4, 0.05);
  scene.phase = draw.even(-3, 3);
  scene.start_position = draw.even(0, 1) * scene.wall_upper;
  scene.counting_limit = draw.even_logarithm(1e-3, 2e-2);
  return scene;
}

/// The same with a disturbance.
inline Scene random_disturbed_machine(std::uint64_t seed) {
  Scene scene = random_machine(seed);
  MachineDraw draw(seed + 1'000'000);
  scene.disturbance = draw.even_logarithm(0.01, 1);
  scene.disturbance_frequency = draw.even_logarithm(0.2, 5);
  return scene;
}

/// A machine as strange as a file may describe it, and valid: its numbers are drawn over several
/// powers of ten, restitution up to 0.9999, clearance from 1e-6 m, a disturbance of up to eight
/// times friction at 0.1 to 60 rad/s. One in ten has no upper wall; some are not about impacts on
/// hard walls.
inline Scene strange_machine(std::uint64_t seed) {
  MachineDraw draw(seed + 2'000'000);
  const auto restitution = [&] { return draw.in(0.1) ? 0 : 1 - draw.even_logarithm(1e-4, 1); };
  Scene scene;
  scene.mass = draw.even_logarithm(0.01, 30);
  scene.wall_upper = draw.even_logarithm(1e-6, 0.1);
  scene.start_position = draw.even(0, 1) * scene.wall_upper;
  if (draw.in(0.1)) scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.restitution_lower = scene.restitution_upper = restitution();
  if (draw.in(0.3)) scene.restitution_upper = restitution();
  scene.friction = draw.in(0.2) ? 0 : draw.even(0.01, 1);
  scene.normal_force = draw.even_logarithm(0.1, 100);
  scene.contact_friction = draw.in(0.3);
  scene.pull = draw.in(0.25) ? 0 : draw.even_logarithm(1e-3, 30) * (draw.in(0.3) ? -1 : 1);
  scene.pull_rotates = draw.in(0.3);
  scene.pull_phase = draw.even(-3, 3);
  scene.centrifugal_mass_radius = draw.in(0.05) ? 0 : draw.even_logarithm(1e-3, 3);
  if (draw.in(0.2)) {
    scene.centrifugal = draw.in(0.5) ? Centrifugal::inward : Centrifugal::outward;
  }
  scene.slider_mass_radius = draw.in(0.7) ? 0 : draw.even_logarithm(1e-5, 0.3);
  scene.phase = draw.even(-3, 3);
  if (draw.in(0.6)) {
    const double held = std::max(scene.friction * scene.normal_force, 0.01);
    scene.disturbance = held * draw.even_logarithm(0.03, 8) * (draw.in(0.2) ? -1 : 1);
    scene.disturbance_frequency = draw.even_logarithm(0.1, 60);
  }
  if (draw.in(0.5)) scene.start_velocity = draw.even(-1, 1) * draw.even_logarithm(1e-3, 1);
  scene.counting_limit = draw.even_logarithm(1e-5, 5e-2);
  scene.window = Revolutions{draw.even_logarithm(1, 50)};
  if (draw.in(0.1)) scene.fidelity = draw.in(0.5) ? Fidelity::automatic : Fidelity::compliant;
  if (draw.in(0.05)) scene.rule = CountRule::peaks;
  return scene;
}

/// Counts the impacts of the last turns of a long simulation.
class LateCollisions : public Observer {
 public:
  LateCollisions(double from, double limit) : from_(from), limit_(limit) {}

  void impact(double time, Wall /*wall*/, double speed) {
    if (time >= from_ && is_counted(speed, limit_)) ++count_;
  }
  int count() const { return count_; }

 private:
  double from_, limit_;
  int count_ = 0;
};

/// The collisions per turn in the last `observed` of `turns` turns from the scene's start.
inline double collisions_in_the_long_run(Scene scene, double omega, int turns, int observed) {
  scene = at_speed(scene, omega);
  scene.window = Revolutions{static_cast<double>(turns)};
  LateCollisions late(duration_of(scene) * (turns - observed) / turns, scene.counting_limit);
  ImpactModel<double>(scene).run(late);
  return static_cast<double>(late.count()) / observed;
}

}  // namespace ricochet::carrier_track
