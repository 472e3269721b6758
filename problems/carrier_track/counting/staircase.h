#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

/// The levels and the steps of a collision count that depends on the speed, without a given limit.
namespace ricochet::carrier_track::inline counting {

/// Counts at the speeds from `lowest` to `highest` [rad/s], both > 0, in parallel.
LogarithmicScan scan_logarithmically(const CountAt& count, double lowest, double highest);

/// The same for a valid scene, whose omega is not used.
LogarithmicScan scan_logarithmically(const Scene& scene, double lowest, double highest);

/// The slowest speed [rad/s] at which steps are searched: 0.1 revolutions per minute.
inline constexpr double slowest_scanned = 0.01;

/// The ratio of the end of a scan to the fastest speed of the staircase. It makes the scan contain
/// all speeds that affect the significance of any step.
inline constexpr double judged_share = 2.25;

/// The staircase of the speeds up to `fastest` [rad/s]. The scan should extend to judged_share
/// times that speed.
Staircase staircase_of(const LogarithmicScan& scan, double fastest);

// Tests whether the count makes a step at a threshold, as the paper says: "the number of
// collisions is 5" below, above it "increases significantly".

/// The way in which a count becomes loud.
enum class Rise {
  step,   ///< it stays loud, and most of the rise is at one speed
  climb,  ///< it stays loud, but rises gradually: the threshold is a convention
  none    ///< it does not stay loud: no significant increase
};

/// The sharpness of a count on the two ranges next to a threshold: down to the threshold / `reach`,
/// and up to `reach` times the threshold or the end of the scan.
struct StepSharpness {
  double threshold;    ///< [rad/s]
  int before, after;   ///< the median counts of the two ranges
  double width;        ///< [rad/s], from the end of `before` to the start of `after`
  double persistence;  ///< share of loud speeds in the range above, in [0, 1]
  Rise rise;
};

/// Least share of loud speeds in the range above for a rise.
inline constexpr double least_persistence = 0.9;

/// Largest width of a step, as a share of its speed.
inline constexpr double widest_step = 0.1;

/// The sharpness at a threshold [rad/s] between two scanned speeds. A speed is loud if it has more
/// than `limit` collisions, see quiet_limit. The ends of the rise are the splits that put the
/// fewest speeds of both ranges on the wrong side, so that a single speed does not widen it. A step
/// has `after` at least 50 % above `before`, and at most the width widest_step. Nothing if one of
/// the ranges has no scanned speed.
std::optional<StepSharpness> step_sharpness(const SpeedScan& scan, double threshold, double limit,
                                            double reach = 1.5);

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

// The quiet ranges of speeds of a staircase that rises and falls.

/// The slowest and the fastest [rad/s] of neighbouring speeds of a scan that are all quiet.
struct QuietInterval {
  double from, to;

  double width() const { return to - from; }
};

/// The quiet intervals, in which all counts are <= `limit`, by increasing speed.
std::vector<QuietInterval> quiet_intervals(const SpeedScan& scan, double limit);

/// The ranges of speeds [rad/s] from `lowest` to `highest`, both > 0, in which a count of at most
/// `most` is not excluded by scan_completely(): because a speed has such a count, or because the
/// scan would take too many simulations there. By increasing speed, apart from each other. The
/// scene is valid, with fidelity impact and the rule of impacts; else std::invalid_argument is
/// thrown.
std::vector<CoordinateRange> not_excluded(const Scene& scene, double lowest, double highest,
                                          double most);

}  // namespace ricochet::carrier_track::inline counting
