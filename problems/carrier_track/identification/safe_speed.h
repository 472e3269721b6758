#pragma once

#include <optional>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// The fastest speed [rad/s] up to which a machine in steady motion has at most two collisions that
/// count per turn; nothing if every speed up to `fastest` [rad/s] has. The scene's start and speed
/// are not used. Speeds are scanned 0.5 % apart, then bisected.
std::optional<double> safe_speed(const Scene& scene, double fastest = 18);

}  // namespace ricochet::carrier_track::inline identification
