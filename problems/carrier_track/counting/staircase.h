#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"

/// The levels and the steps of a collision count that depends on the speed, where nobody says which
/// count is too many.
namespace ricochet::carrier_track::inline counting {

/// Collision counts at the speeds exp(k / per_e_fold), k = first, first + 1, ...: the same speeds,
/// wherever a scan ends, and the same number of them between a speed and its double.
struct LogarithmicScan {
  static constexpr double per_e_fold = 500;
  int first = 0;
  std::vector<int> counts;

  double omega(std::size_t k) const;  ///< [rad/s]
};

/// The speeds from `lowest` to `highest` [rad/s], both > 0, counted in parallel.
LogarithmicScan scan_logarithmically(const CountAt& count, double lowest, double highest);

/// The same for a valid scene, whose omega is not used.
LogarithmicScan scan_logarithmically(const Scene& scene, double lowest, double highest);

/// A step up, from a level to one that is louder by half and by two collisions at least (one more
/// or less is the same kind of count, see Score). Both levels hold over the same ratio of speeds:
/// nine tenths of those from omega / reach to omega have at most `below`, nine tenths of those from
/// there to omega reach have at least `above`.
struct Step {
  double omega;  ///< [rad/s], where the speeds within reach divide best
  int below, above;
  double reach;          ///< the most significant of 1.1..2
  double misclassified;  ///< share of the speeds within reach on the wrong side, in [0, 1]
  /// ln((1 + above) / (1 + below)) ln(reach): how much louder, times how long it lasts on a
  /// logarithmic axis. Whatever lies beyond half and twice the speed does not change it.
  double significance;
  /// [rad/s], lowest speed of a finer scan, where there is one, with more than limit() collisions.
  std::optional<double> first_loud = {};

  double limit() const { return (below + above) / 2.0; }  ///< counts up to here are below
};

/// Speeds [rad/s] with one kind of count.
struct Level {
  double from, to;
  int low, typical, high;  ///< a tenth of the speeds has less than low; the median; a tenth more
};

struct Staircase {
  std::vector<Step> steps;    ///< by rising speed
  std::vector<Level> levels;  ///< between them, one more than steps

  /// The most significant step, the slowest of equals; nothing where there is none: then there is
  /// no threshold.
  std::optional<Step> main_step() const;
};

/// The slowest speed [rad/s] whose steps are looked for: a tenth of a turn a minute.
inline constexpr double slowest_scanned = 0.01;

/// How far beyond the fastest speed asked for a scan must go for all steps up to there to be
/// judged by all that can make them significant: as a ratio.
inline constexpr double judged_share = 2.25;

/// The staircase of the speeds up to `fastest` [rad/s]. The scan should go on to judged_share times
/// that.
Staircase staircase_of(const LogarithmicScan& scan, double fastest);

}  // namespace ricochet::carrier_track::inline counting
