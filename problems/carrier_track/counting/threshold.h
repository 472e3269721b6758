#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// The two speeds [rad/s] at which a published figure shows x(t).
struct Figure {
  int number;
  double quiet, loud;
};

/// Published values of a machine, for comparison; without value if not published.
struct Claim {
  std::optional<double> threshold;  ///< [rad/s]
  std::optional<int> quiet_count;   ///< the count below the threshold
  std::optional<Figure> figure;
};

// Defines the threshold of a staircase of counts, and the other parts of the score of an
// interpretation of the paper.

/// The collision count at a speed [rad/s]. May be called from several threads at once.
using CountAt = std::function<int(double omega)>;

/// Counts at every speed of the grid, in parallel.
SpeedScan scan_speeds(const CountAt& count, double step, double highest);

/// The same for a valid scene, whose omega is not used.
SpeedScan scan_speeds(const Scene& scene, double step, double highest);

/// The same, of as many of the slowest speeds as the TimeLimit allows; scan_speeds() throws
/// TimeLimitReached.
SpeedScan scan_slowest_speeds(const CountAt& count, double step, double highest);
SpeedScan scan_slowest_speeds(const Scene& scene, double step, double highest);

/// Whether a scan has all its speeds up to the highest [rad/s].
bool extends_to(const SpeedScan& scan, double highest);

/// Every `stride`-th speed of a scan.
SpeedScan thinned(const SpeedScan& scan, std::size_t stride);

/// The split that misclassifies the fewest speeds, on a tie the lowest. It has no speed if calling
/// all speeds loud, or all quiet, misclassifies the fewest: then there is no threshold in the
/// range.
Split best_split(const SpeedScan& scan, double limit);

/// The most common count, on a tie the lowest. Nothing for an empty range.
std::optional<int> most_common(const std::vector<int>& counts);

/// One of the paper's example speeds, and whether the count is on the side that its figure shows.
struct Example {
  double omega;  ///< [rad/s]
  bool loud;     ///< according to the paper
  int count;
  bool right;
};

/// The six parts of the score, and further results of the scans.
struct Score {
  int quiet_count = 0;               ///< (1) most common count below the reference speed
  std::optional<double> purity;      ///< (2) share of those speeds with the quiet count +- 1
  std::optional<double> threshold;   ///< (3) [rad/s], best split of the fine scan
  double misclassified = 0;          ///< (4) share of speeds that this split misclassifies
  std::optional<double> loudness;    ///< (5) median count above the reference / quiet count
  std::vector<Example> examples;     ///< (6)
  std::optional<double> first_loud;  ///< [rad/s], lowest loud speed of the fine scan
  std::int64_t evaluations = 0;      ///< simulations
  double seconds = 0;                ///< elapsed
};

struct ScanOptions {
  double step = 1e-3;       ///< [rad/s] of the fine scan, which locates threshold and first_loud
  std::size_t stride = 10;  ///< every stride-th speed is used for parts 1, 2, 4, 5
  double highest = 18.0;    ///< [rad/s]
};

/// Without a claim, the quiet count is that of the speeds up to this share of the range; no
/// threshold of the paper is lower.
inline constexpr double quiet_share = 0.1;

/// Scores a scene against a claim. The reference speed is the claimed threshold. Without one, the
/// quiet count is that of the lowest tenth of the range, and the reference of parts 2 and 5 is the
/// threshold found.
Score score(const Scene& scene, const Claim& claim, const ScanOptions& options);

/// The same from a scan already made.
Score score(const Scene& scene, const Claim& claim, const SpeedScan& scan, std::size_t stride);
Score score(const CountAt& count, const Claim& claim, const SpeedScan& scan, std::size_t stride);

/// Part 1 of the score only: simulates only the speeds below the reference.
int quiet_count(const Scene& scene, const Claim& claim, const ScanOptions& options);

/// Counts up to this limit are quiet.
inline double quiet_limit(int quiet_count) {
  return 1.5 * quiet_count;
}

/// Collision count of a valid scene at a speed [rad/s]. For many scenes or speeds: count_scan.h.
int count_at(const Scene& scene, double omega);

}  // namespace ricochet::carrier_track::inline counting
