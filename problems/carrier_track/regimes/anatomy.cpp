#include "problems/carrier_track/regimes/anatomy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/regimes.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double same_angle = 1e-6;  // [rad]
constexpr double same_speed = 1e-6;  // relative

/// The angle [rad] of the driver plate at an impact.
double angle_of(const Scene& scene, const Impact& impact) {
  return scene.phase + scene.omega * impact.time;
}

/// Whether the orbit has the same impact; `impact` is one of `scene`.
bool has(const SteadyMotion& motion, const Scene& scene, const Impact& impact) {
  return std::any_of(motion.impacts.begin(), motion.impacts.end(), [&](const Impact& known) {
    const double apart = angle_of(scene, impact) - angle_of(motion.orbit, known);
    return known.wall == impact.wall &&
           std::abs(std::remainder(apart, 2 * std::numbers::pi)) < same_angle &&
           std::abs(impact.speed / known.speed - 1) < same_speed;
  });
}

}  // namespace

std::optional<Anatomy> anatomy_of(const Scene& scene, const std::vector<Impact>& impacts) {
  if (!has_regimes(scene) || !(scene.omega > 0) || forcing_turns(scene) == 0) return std::nullopt;
  SteadyMotion motion;
  try {
    motion = steady_motion(scene);
  } catch (const std::runtime_error&) {  // more impacts than a simulation may have
    return std::nullopt;
  }
  if (!motion.settled) return std::nullopt;
  Anatomy anatomy;
  anatomy.per_turn = motion.collisions_per_turn();
  for (const Impact& impact : impacts) {
    const bool stays = has(motion, scene, impact);
    anatomy.in_the_long_run.push_back(stays);
    if (is_counted(impact.speed, scene.counting_limit)) {
      ++(stays ? anatomy.of_long_run : anatomy.of_start);
    }
  }
  return anatomy;
}

}  // namespace ricochet::carrier_track::inline regimes
