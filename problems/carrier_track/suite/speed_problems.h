#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

/// The speed with the fewest collisions.
namespace ricochet::carrier_track::inline problems {

/// Minimise the collision count over the speed: an integer staircase without derivatives. The
/// smooth surrogate has them.
Problem count_problem(const Machine& machine);

// The top speed in the window.

/// Minimise -speed subject to count <= quiet limit, without derivatives. The surrogate has them;
/// its constraint is to stay below the half_level of the limit.
Problem top_speed_problem(const Machine& machine);

/// The same problem in another family, whose name is its prefix.
Problem top_speed_problem_of(const std::string& family, const Machine& machine);

/// The range of driver plate speeds [rad/s]. The paper's range is 0..18 rad/s; at 0 a window of
/// revolutions would never end.
inline constexpr double slowest_speed = 0.01;
inline constexpr double fastest_speed = 18.0;

/// -x[0]: minimising it maximises the speed.
struct Slowness {
  static constexpr int jet_size = 1;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return -x[0];
  }
};

/// [rad/s] below the top speed in the window that still count as solved.
inline constexpr double speed_tolerance = 0.01;

/// [rad/s], penalty for one collision too many: no gain of speed in the box outweighs half a
/// collision.
inline constexpr double speed_penalty = 2 * fastest_speed;

/// A problem of the speed alone, "<family>-<id>", without an objective yet.
Problem speed_problem(const std::string& family, const Machine& machine, std::string source);

/// Which counts of a window are quiet, for a machine of which no paper claims anything.
struct QuietRule {
  double limit = 0;                 ///< a count up to this is quiet
  std::optional<double> threshold;  ///< [rad/s]
};

/// Share of the threshold from which on counts set the limit.
inline constexpr double limit_from = 0.9;

/// The rule that agrees with the long run. The threshold is the speed up to which no turn of the
/// long run has more than quiet_per_turn collisions, between hard walls whatever the fidelity. The
/// limit is half a collision above the most that the window, with those of the start, has from
/// limit_from of that speed to it, at speeds `step` apart [rad/s]. A machine that is quiet up to
/// the fastest speed has no threshold. For one that is loud at once, or that counts peaks, both are
/// those of score() without a claim. The scene must be valid, at a constant speed.
QuietRule quiet_rule_of(const Scene& scene, double step);

/// The most collisions in the window at multiples of the step from limit_from * `end` to `end`; at
/// `end` itself [rad/s] if there is no such multiple.
int most_collisions_below(const Scene& scene, double end, double step);

}  // namespace ricochet::carrier_track::inline problems
