#pragma once

/// @file
/// Collision counts over a range of speeds, and the fastest quiet speed.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/regimes.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Collision counts at the evenly spaced speeds step, 2 step, ..., highest.
struct SpeedScan {
  double step;              ///< [rad/s]
  std::vector<int> counts;  ///< counts[k] belongs to omega(k)

  double omega(std::size_t k) const { return static_cast<double>(k + 1) * step; }
};

/// The speed that best divides a set of counts into quiet below and loud above; quiet means <=
/// limit (see quiet_limit).
struct Split {
  std::optional<double> speed;       ///< [rad/s], midway between two scanned speeds
  std::optional<double> first_loud;  ///< [rad/s], lowest scanned speed that is loud
  double misclassified = 0;          ///< share of the scanned speeds on the wrong side, in [0, 1]
};

/// A range of speeds with the same collision count.
struct CountPiece {
  double from, to;  ///< [rad/s]
  int count;
};

/// The quantity that a limit refers to.
enum class Measure {
  collisions,           ///< in the window
  collisions_per_turn,  ///< of the driver plate: of every turn in the long run, if the scene has
                        ///< regimes (has_regimes); else the mean of the window
  energy,               ///< [J], dissipated by the walls in the window
  impact_speed          ///< [m/s], speed of the fastest impact
};

struct Limit {
  Measure measure = Measure::collisions;
  double at_most = 0;
};

/// Collision counts at the speeds exp(k / per_e_fold), k = first, first + 1, ...: the speeds do not
/// depend on the ends of the scan, and any doubling of the speed contains the same number of them.
struct LogarithmicScan {
  static constexpr double per_e_fold = 500;
  int first = 0;
  std::vector<int> counts;

  double omega(std::size_t k) const;  ///< [rad/s]
};

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

/// Allowed fastest speeds [rad/s] of a range.
inline constexpr double shortest_range = 0.1;
inline constexpr double longest_range = 1000;

/// The collisions in a turn that are quiet unless another limit is given: one with each wall, which
/// every carrier has that is thrown across its clearance and back.
inline constexpr double quiet_per_turn = 2;

/// What is asked of quiet_speed().
struct QuietSpeedOptions {
  /// Default: quiet_per_turn collisions per turn; for a scene without regimes the limit of the
  /// staircase's main step.
  std::optional<Limit> limit;
  double step = 1e-3;   ///< [rad/s], from 1e-7 to a tenth of the fastest speed
  double fastest = 18;  ///< [rad/s], from shortest_range to longest_range
};

/// The count at a speed, and its certainty.
struct CountThere {
  double omega;  ///< [rad/s]
  int count;
  double per_turn;
  bool certain;
  std::string doubt;  ///< empty if certain
};

struct QuietSpeed {
  QuietSpeedOptions options;
  std::optional<Limit> limit;  ///< given or by default; nothing if there is no threshold
  /// Of the machine in the long run, if the limit is about it; empty for a limit of the window.
  std::vector<Regime> regimes;
  // Of a limit of the window.
  LogarithmicScan scan;  ///< counts, beyond the fastest speed
  SpeedScan fine;        ///< counts, up to the fastest speed
  Staircase staircase;   ///< with its steps located in the fine scan
  Split split;           ///< by the limit; in the long run its speeds are the border
  /// Speeds below the first loud speed of the fine scan that it steps over and whose collision
  /// count is above the limit, if any; split.first_loud is then the lowest of them.
  std::optional<CountPiece> stepped_over;
  std::optional<double>
      fastest_quiet;               ///< [rad/s], last multiple of the step before the first loud
  std::vector<CountThere> around;  ///< of a window: just below the answer, at it, and just above
  /// No speed keeps the limit: there is neither a fastest quiet speed nor one that divides.
  bool loud_everywhere = false;
  /// [rad/s], if a TimeLimit was reached: nothing is known of faster speeds, and what is said of
  /// slower ones may be incomplete.
  std::optional<double> reached;

  bool is_of_the_long_run() const { return !regimes.empty(); }
};

/// The fastest quiet speed of a machine, as `ricochet threshold` finds it: from its regimes if the
/// limit is one of collisions per turn, else from about 20,000 simulations of its window. The
/// scene's omega is not used. If a TimeLimit is reached, the answer says up to which speed. Throws
/// InputError if the scene or an option is invalid, or if the scene's speed is a profile;
/// TimeLimitReached if nothing is known.
QuietSpeed quiet_speed(const Scene& scene, const QuietSpeedOptions& options = {});

}  // namespace ricochet::carrier_track::inline counting
