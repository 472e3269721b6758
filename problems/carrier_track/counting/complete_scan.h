#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ricochet/scene.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {

struct CompleteScan {
  std::vector<CountPiece> pieces;  ///< by increasing speed; gaps are at most the resolution
  std::int64_t simulations = 0;    ///< number of simulations with derivatives

  /// The first piece with more than `limit` collisions.
  std::optional<CountPiece> first_above(double limit) const;
};

struct CompleteScanOptions {
  double resolution = 1e-6;  ///< [rad/s], accuracy of the ends of pieces
  /// Limit of simulations; each costs as much as two to four of an even scan. No part of the range
  /// may use much more than its share of them.
  std::int64_t most = 4000;
};

/// The collision counts of a valid scene from `lowest` to `highest` [rad/s], both > 0, without
/// missing narrow windows. Two speeds are neighbours only if the motions at both, with their
/// derivatives, indicate that no feature starts or stops to count between them, and that no impact
/// appears or vanishes. Otherwise the middle is simulated too. The indication is an estimate from
/// the curvature of every margin, not a proof: a motion that changes and changes back between two
/// speeds is missed if neither speed shows a sign of it.
///
/// Returns nothing if the scan would take more simulations than allowed, for instance if the motion
/// is chaotic. Throws std::invalid_argument unless the scene has fidelity impact and the rule of
/// impacts.
std::optional<CompleteScan> scan_completely(const Scene& scene, double lowest, double highest,
                                            const CompleteScanOptions& options = {});

}  // namespace ricochet::carrier_track::inline counting
