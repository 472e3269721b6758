#pragma once

#include <cmath>
#include <cstdint>

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
