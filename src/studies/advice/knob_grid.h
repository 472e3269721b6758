#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "src/report/json.h"
#include "src/studies/advice/knob.h"

/// What a machine's fastest quiet speed becomes when its constants change.
namespace ricochet::studies::advice {

/// Speeds, each by the same ratio more than the one before.
struct CoarseScan {
  double lowest, highest;  ///< [rad/s], > 0
  double ratio = 1.01;
};

/// Where a machine is quiet by a limit, as seen by a coarse scan.
struct QuietRange {
  /// [rad/s], up to which every scanned speed is quiet, located to a sixteenth of the scan's step;
  /// the highest where all are, nothing where the lowest is loud already.
  std::optional<double> quiet;
  std::optional<double> divide;  ///< [rad/s], where quiet and loud speeds divide best
  bool to_the_end = false;       ///< no scanned speed is loud
  bool simulated = true;         ///< false: more impacts than a simulation may have
};

/// From an eighth of the answer's own speed to the fastest one asked for, with a ratio of 1.01, or
/// of 1.04 for compliant walls, which take some thirty times as long; nothing where the answer has
/// no limit.
std::optional<CoarseScan> coarse_scan(const carrier_track::Scene& scene,
                                      const carrier_track::QuietSpeed& answer);

QuietRange quiet_range(const carrier_track::Scene& scene, const carrier_track::Limit& limit,
                       const CoarseScan& scan);

/// The quiet ranges of a machine for every combination of its knobs' levels, and along each knob
/// with the others at the machine's own.
struct KnobGrid {
  static constexpr std::size_t points_of_a_line = 21;

  CoarseScan scan;
  std::vector<Knob> knobs;
  std::vector<std::vector<double>> levels;     ///< of each knob
  std::vector<QuietRange> combinations;        ///< the last knob's level changes first
  std::vector<std::vector<QuietRange>> lines;  ///< of each knob, at shares -1 .. 1
  QuietRange own;
};

/// Nothing where the answer has no limit. Takes some 150,000 simulations, in parallel.
std::optional<KnobGrid> knob_grid(const carrier_track::Scene& scene,
                                  const carrier_track::QuietSpeed& answer);

/// For the page: knobs with their levels, an answer for each combination, lines, and what turning
/// each knob alone buys, the one that buys most first. Null where there is no grid.
report::Json json_of(const std::optional<KnobGrid>& grid);

}  // namespace ricochet::studies::advice
