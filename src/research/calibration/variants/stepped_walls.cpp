#include "src/studies/trials/stepped_walls.h"

#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/reference_integrators/forces.h"
#include "problems/carrier_track/reference_integrators/wall_force.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

namespace {

/// The speed [m/s] at the wall of a body that a steady push [m/s^2], both taken into the wall,
/// leads there over a distance [m]; that at the end of the step where it would turn before.
double speed_at_wall(double speed, double push, double distance, double at_end) {
  const double square = speed * speed + 2 * push * distance;
  return square > 0 ? std::sqrt(square) : std::max(speed, at_end);
}

/// [m/s]; a contact is damped as one of this speed where it begins slower: else a body that is
/// laid on a wall would meet a damper of any strength, and a method that is not implicit creep.
double slowest_damped(const Scene& scene) {
  return std::max(scene.slowest, sliding_speed);
}

}  // namespace

int stepped_count(const Scene& scene, const OdeTolerances& tolerances, int most) {
  const Forces forces = forces_of(scene);
  WallForce wall = wall_force_of(scene);
  const double gap = scene.wall_upper - scene.wall_lower;
  const auto push = [&](const OdeState& x, double time) {
    return forces.applied(time) - forces.friction * std::tanh(x[1] / sliding_speed);
  };
  Ode45 method(
      [&](const OdeState& x, double time) {
        return OdeState{x[1], push(x, time) + wall({x[0], x[1]})};
      },
      {scene.start_position, scene.start_velocity}, duration_of(scene), tolerances);
  int count = 0;
  const double window = duration_of(scene);
  try {
    while (method.time() < window) {
      const double time = method.time();
      const OdeState before = method.state();
      if (!(wall.depth(before[0]) > 0)) {
        wall.speed = std::max(std::abs(before[1]), slowest_damped(scene));
      }
      method.step();
      const OdeState& after = method.state();
      const double depth = wall.depth(after[0]);
      if (method.steps() > most_ode_steps || depth > gap) return most + 1;
      if (!(depth > 0) || wall.depth(before[0]) > 0) continue;
      const int into = after[0] > scene.wall_upper ? +1 : -1;
      const double distance =
          into > 0 ? scene.wall_upper - before[0] : before[0] - scene.wall_lower;
      const double speed =
          speed_at_wall(into * before[1], into * push(before, time), distance, into * after[1]);
      if (is_counted(speed, scene.slowest) && ++count > most) return count;
    }
  } catch (const std::runtime_error&) {
    return most + 1;
  }
  return count;
}

}  // namespace ricochet::studies::trials
