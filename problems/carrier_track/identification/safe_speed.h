#pragma once

#include <optional>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// The fastest speed [rad/s] up to which a machine has at most quiet_per_turn collisions a turn in
/// the long run, from rest on the lower wall; nothing if every speed up to `fastest` [rad/s] has.
/// The scene's start and speed are not used.
std::optional<double> safe_speed(const Scene& scene, double fastest = 18);

}  // namespace ricochet::carrier_track::inline identification
