#include "src/research/calibration/variants/stepped_walls.h"

#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/check/reference_integrators/forces.h"
#include "problems/carrier_track/check/reference_integrators/wall_force.h"
#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::studies::variants {

using namespace carrier_track;

namespace {

/// The speed [m/s] at the wall of a body under a steady acceleration [m/s^2], both positive into
/// the wall, after a distance [m]; the speed at the end of the step if it turns back before.
double speed_at_wall(double speed, double push, double distance, double at_end) {
  const double square = speed * speed + 2 * push * distance;
  return square > 0 ? std::sqrt(square) : std::max(speed, at_end);
}

/// [m/s]; slower contacts are damped as if they began at this speed. Otherwise a body laid on a
/// wall would have unbounded damping, and an explicit method would need tiny steps.
double slowest_damped(const Scene& scene) {
  return std::max(scene.counting_limit, sliding_speed);
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
      if (is_counted(speed, scene.counting_limit) && ++count > most) return count;
    }
  } catch (const std::runtime_error&) {
    return most + 1;
  }
  return count;
}

}  // namespace ricochet::studies::variants
