#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

/// Most samples of a path.
inline constexpr std::size_t most_samples = 10'000'000;

/// Simulates a valid scene and keeps everything; simulate() checks the scene, and this does not, so
/// that tests can go beyond the limits of a file. `smoothing` is finite and >= 0, `samples` at most
/// most_samples; else it throws InputError. The path is sampled at the ends of every stretch, at
/// every step in a compliant wall, and evenly in between, about `samples` times in the window; with
/// 0 there is no path. No sample stands twice in a row. Costs five simulations, four of them for
/// the certainty; with fidelity auto up to fifteen.
Recording record(const Scene& scene, double smoothing, std::size_t samples);

/// An event to which a count rule applies: an impact or a maximum.
struct Feature {
  double time;      ///< [s]
  double position;  ///< [m]
  bool counts;
};

/// All impacts of a recording, or all its maxima, depending on the rule of the scene.
std::vector<Feature> features_of(const Scene& scene, const Recording& recording);

/// The features of features_of() that count.
std::vector<Feature> counted_features(const Scene& scene, const Recording& recording);

/// A part of a window [s].
struct Stretch {
  double from, to;
};

/// The busiest part of the window: the shortest stretch with two thirds of the features that count,
/// extended by a quarter of its length on either side, within the window. Nothing if it is not a
/// small part of the window, or if fewer than three features count.
std::optional<Stretch> busiest_stretch(const Scene& scene, const Recording& recording);

}  // namespace ricochet::carrier_track::inline counting
