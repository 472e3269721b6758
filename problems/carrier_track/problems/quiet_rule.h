#pragma once

#include <optional>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline problems {

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

}  // namespace ricochet::carrier_track::inline problems
