#pragma once

/// @file
/// The motion of a machine, and its collision counts.

#include <cstddef>
#include <span>
#include <vector>

#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline counting {

/// The default smoothing parameter: the weight of an impact is 0.5 at the counting limit, 0.9 at
/// 1.73 times the limit.
inline constexpr double default_smoothing = 0.25;

/// Simulates a scene and keeps everything, as `ricochet simulate` does. `smoothing`: the smoothing
/// parameter of the surrogate, finite and > 0. The path is sampled at the ends of every flight, at
/// every step in a compliant wall, and evenly in between, about `samples` times in the window; with
/// 0 there is no path. Costs five simulations, four of them for the certainty; with fidelity
/// automatic up to fifteen. If a TimeLimit is reached, the recording ends there. Throws InputError
/// if the scene or the smoothing parameter is invalid, or for more than 10,000,000 samples.
Recording simulate(const Scene& scene, double smoothing = default_smoothing,
                   std::size_t samples = 0);

/// The collision counts of a scene at several constant speeds [rad/s], without their certainty: one
/// simulation each. Neighbours should be similar, which makes it several times as fast. Throws
/// InputError if the scene or a speed is invalid; TimeLimitReached.
std::vector<int> counts(const Scene& scene, std::span<const double> speeds);

}  // namespace ricochet::carrier_track::inline counting
