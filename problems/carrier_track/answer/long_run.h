#pragma once

#include "ricochet/regimes.h"
#include "ricochet/threshold.h"

/// Limits that are about the motion in the long run, and not about a window after a start.
namespace ricochet::carrier_track::inline answer {

/// [rad/s], where the speeds of a limit in the long run begin.
inline constexpr double slowest_of_a_range = 0.01;

/// Whether a limit of this scene is about the long run; see Measure.
inline bool is_of_the_long_run(const Scene& scene, const Limit& limit) {
  return limit.measure == Measure::collisions_per_turn && has_regimes(scene);
}

/// The limit that quiet_speed() begins with: the one that is asked for, or that of a turn.
inline Limit limit_of(const QuietSpeedOptions& options) {
  return options.limit.value_or(Limit{Measure::collisions_per_turn, quiet_per_turn});
}

}  // namespace ricochet::carrier_track::inline answer
