#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"

/// The levels and the steps of a collision count that depends on the speed, without a given limit.
namespace ricochet::carrier_track::inline counting {

/// Collision counts at the speeds exp(k / per_e_fold), k = first, first + 1, ...: the speeds do not
/// depend on the ends of the scan, and any doubling of the speed contains the same number of them.
struct LogarithmicScan {
  static constexpr double per_e_fold = 500;
  int first = 0;
  std::vector<int> counts;

  double omega(std::size_t k) const;  ///< [rad/s]
};

/// Counts at the speeds from `lowest` to `highest` [rad/s], both > 0, in parallel.
LogarithmicScan scan_logarithmically(const CountAt& count, double lowest, double highest);

/// The same for a valid scene, whose omega is not used.
LogarithmicScan scan_logarithmically(const Scene& scene, double lowest, double highest);

/// A step up from one level to another that is at least 50 % and two collisions higher (one
/// collision more or less is the same level, see Score). Both levels extend over the same ratio of
/// speeds: nine tenths of the speeds from omega / reach to omega have at most `below` collisions,
/// nine tenths of those from omega to omega reach have at least `above`.
struct Step {
  double omega;  ///< [rad/s], divides the speeds within reach best
  int below, above;
  double reach;          ///< ratio in 1.1..2 that makes the step most significant
  double misclassified;  ///< share of the speeds within reach on the wrong side, in [0, 1]
  /// ln((1 + above) / (1 + below)) ln(reach): the increase, times the length of the levels on a
  /// logarithmic axis. Only speeds from half to twice the speed of the step affect it.
  double significance;
  /// [rad/s], the lowest speed with more than limit() collisions in a finer scan, if there is one.
  std::optional<double> first_loud = {};

  double limit() const { return (below + above) / 2.0; }  ///< counts <= this are below
};

/// Speeds [rad/s] between two steps, and their counts.
struct Level {
  double from, to;
  int low, typical, high;  ///< 10 % quantile, median, 90 % quantile of the counts
};

struct Staircase {
  std::vector<Step> steps;    ///< by increasing speed
  std::vector<Level> levels;  ///< between the steps; one more than steps

  /// The most significant step, on a tie the slowest. Nothing if there is no step, hence no
  /// threshold.
  std::optional<Step> main_step() const;
};

/// The slowest speed [rad/s] at which steps are searched: 0.1 revolutions per minute.
inline constexpr double slowest_scanned = 0.01;

/// The ratio of the end of a scan to the fastest speed of the staircase. It makes the scan contain
/// all speeds that affect the significance of any step.
inline constexpr double judged_share = 2.25;

/// The staircase of the speeds up to `fastest` [rad/s]. The scan should extend to judged_share
/// times that speed.
Staircase staircase_of(const LogarithmicScan& scan, double fastest);

}  // namespace ricochet::carrier_track::inline counting
