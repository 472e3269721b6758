#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Neighbouring speeds with one collision count.
struct CountPiece {
  double from, to;  ///< [rad/s]
  int count;
};

struct CompleteScan {
  std::vector<CountPiece> pieces;  ///< by rising speed, no further apart than the resolution
  std::int64_t simulations = 0;    ///< with derivatives

  /// The slowest speeds with more than `limit` collisions.
  std::optional<CountPiece> first_above(double limit) const;
};

struct CompleteScanOptions {
  double resolution = 1e-6;  ///< [rad/s], to which the ends of pieces are found
  /// Simulations, each of the price of two to four of an even scan. No share of the range may take
  /// much more than its share of them.
  std::int64_t most = 4000;
};

/// The collision counts of a valid scene from `lowest` to `highest` [rad/s], both > 0, with no
/// narrow window stepped over: two speeds are neighbours only where the motions at both, with their
/// derivatives, tell that nothing begins or ceases to count between, and no wall is touched or
/// missed; else the middle is simulated too. What is told is an estimate by the curvature of every
/// margin, not a proof: a motion that changes and changes back between two speeds with no sign of
/// it at either is not seen.
///
/// Nothing where the scan would take more simulations than allowed, as where the motion is chaotic.
/// The scene is of fidelity impact and the rule of impacts; another throws std::invalid_argument.
std::optional<CompleteScan> scan_completely(const Scene& scene, double lowest, double highest,
                                            const CompleteScanOptions& options = {});

}  // namespace ricochet::carrier_track::inline counting
