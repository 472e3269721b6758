// For engines that advance by steps: a scene in the engine's units, and impacts read off the jumps
// of the velocity.
#pragma once

#include "tool.h"

namespace impact_test {

/// The scene with another unit of length, the body's mass as the unit of mass, and the lower wall
/// at zero. `units`: how many of them are a metre.
inline Scene in_units(Scene scene, double units) {
  for (Segment& segment : scene.segments) {
    for (Term& term : segment.terms) {
      for (double& a : term.amplitude) a *= units / scene.mass;
    }
  }
  scene.friction *= units / scene.mass;
  scene.mass = 1;
  scene.position = (scene.position - scene.lower) * units;
  scene.upper = (scene.upper - scene.lower) * units;
  scene.lower = 0;
  scene.velocity *= units;
  scene.slowest *= units;
  return scene;
}

/// What an engine likes.
struct Likes {
  double clearance;  ///< in its units of length
  double threshold;  ///< of the speed that the largest force gives in a step; see below
  /// The threshold in its units if it cannot be set; the unit of length then makes it the one
  /// wanted.
  double fixed_threshold = 0;
};

/// Simulates with the steps that engines are run with. A world is made by World(scene, step,
/// threshold) and has step(force), position() and velocity(). A contact slower than the threshold
/// is to be one without restitution; a body there rests.
template <typename World>
Result step_through(const Scene& in_metres, const Call& call, const Likes& likes) {
  const double step = call.pick(1.0 / 240, 1e-3, 1e-4);
  const double slow = likes.threshold * in_metres.largest_force() / in_metres.mass * step;
  const double units = likes.fixed_threshold > 0 ? likes.fixed_threshold / slow
                                                 : likes.clearance / in_metres.length();
  const Scene scene = in_units(in_metres, units);
  const double threshold = slow * units;
  World world(scene, step, threshold);
  Result result;
  int touched = 0;  // the wall in the last step: -1 lower, 1 upper
  const auto steps = static_cast<long>(std::ceil(in_metres.duration / step));
  for (long k = 0; k < steps; ++k) {
    const double time = step * static_cast<double>(k);
    const double position = world.position();
    const double velocity = world.velocity();
    const double pushed = scene.force(time) * step;
    world.step(scene.force(time));
    const double jump = world.velocity() - velocity - pushed;
    const double unsure = 1e-4 * (std::abs(velocity) + std::abs(pushed));
    const bool touches = std::abs(jump) > 1.01 * scene.friction * step + unsure;
    const int wall = !touches ? 0 : jump > 0 ? -1 : 1;
    const double approach = wall * (velocity + pushed);
    const bool is_same = wall == touched && wall * velocity > 0;  // it is not yet thrown back
    if (approach > threshold && !is_same) {
      const double gap = wall < 0 ? position : scene.upper - position;
      const double since = std::clamp(gap / approach, 0.0, step);
      result.impacts.push_back({time + since, wall > 0, approach / units});
    }
    touched = wall;
    const double depth = std::max(-world.position(), world.position() - scene.upper);
    result.deepest = std::max(result.deepest, depth / units);
  }
  result.end = {in_metres.lower + world.position() / units, world.velocity() / units};
  return result;
}

/// A driver's main().
template <typename World>
int run_engine(int argc, char** argv, const Likes& likes) {
  return run(argc, argv, [&](const Scene& scene, const Call& call) {
    return step_through<World>(scene, call, likes);
  });
}

}  // namespace impact_test
