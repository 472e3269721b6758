#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ricochet/scene.h"

/// @file
/// The results of a simulation.
namespace ricochet::carrier_track::inline models {

enum class Wall { lower, upper };

/// The state in which a simulation ended.
template <class Scalar>
struct End {
  Scalar time;               ///< [s]
  Scalar position;           ///< [m]
  Scalar velocity;           ///< [m/s]
  std::int64_t evaluations;  ///< of the closed-form flight
};

}  // namespace ricochet::carrier_track::inline models

namespace ricochet::carrier_track::inline counting {

/// A turning point that comes near the wall ahead of it without touching it.
struct Graze {
  double time;  ///< [s]
  Wall wall;
  double distance;  ///< [m], > 0
};

/// Why a count is not certain: the first cause in time.
enum class Doubt {
  none,
  margin,     ///< the change moves a feature's margin z to or across zero
  window,     ///< the change moves a feature that counts to or across the end of the window
  graze,      ///< the change makes an impact or a maximum appear or vanish
  sensitive,  ///< the change grows more than 1e6-fold, or its simulation fails
  endless,    ///< infinitely many maxima count, see FeatureTrace
  unfinished  ///< a TimeLimit was reached before the end of the simulation or of the comparison
};

struct Certainty {
  /// True if there is no doubt: every feature that counts has a counterpart in every changed scene,
  /// and each |margin| is larger than its change and than perturbation_size.
  bool certain = true;
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::optional<Graze> graze;    ///< the nearest in the window; nothing without a turning point
  /// Largest difference of a feature's scaled margin between a changed scene and the given one, in
  /// units of perturbation_size, of the features up to the first in doubt; 0 without features.
  double growth = 0;
  Doubt doubt = Doubt::none;
  std::string reason;  ///< the doubt as a sentence without a full stop; empty if certain
};

struct Impact {
  double time;  ///< [s]
  Wall wall;
  double speed;  ///< [m/s], approach speed
};

struct Peak {
  double time;      ///< [s]
  double position;  ///< [m]
};

struct Sample {
  double time;      ///< [s]
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// All results of one simulation.
struct Recording {
  Fidelity fidelity = Fidelity::impact;  ///< the level simulated; for auto the one needed
  int count = 0;
  double surrogate = 0;
  Certainty certainty;  ///< of the count
  /// Whether the whole window was simulated; if not, because a TimeLimit was reached, all is that
  /// of the time up to end.time, and end.velocity is NaN.
  bool complete = true;
  std::vector<Impact> impacts;
  std::vector<Peak> peaks;
  std::vector<Sample> path;
  End<double> end{};
};

// @file
// The motion of a machine, and its collision counts.

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

/// @file
/// The regimes of a machine: what its carrier does in the long run, over the speed.
namespace ricochet::carrier_track::inline regimes {

/// What ends a regime at its fast end.
enum class RegimeEnd {
  release,         ///< the forces start, or cease, to beat friction
  counting_limit,  ///< an impact passes the counting limit
  grazing,         ///< the carrier starts, or ceases, to touch a wall
  end_of_rest,     ///< the carrier ceases to come to rest in each period
  start_of_rest,   ///< it begins to
  flip,            ///< period doubling: an eigenvalue passes -1
  fold,            ///< the orbit meets an unstable one and vanishes: an eigenvalue reaches +1
  irregular,       ///< the motion ceases, or begins, to repeat
  range,           ///< the end of the range asked for
  time_limit       ///< the TimeLimit was reached: what comes next is not known
};

/// The name as it stands in JSON: "counting-limit".
std::string name_of(RegimeEnd end);

/// What a carrier does in the long run at one speed.
struct LongRun {
  /// The machine at that speed: it starts on the motion, and its window is one period.
  Scene orbit;
  double collisions_per_turn;  ///< mean
  double energy_per_turn;      ///< [J], that the walls take
  double fastest_impact;       ///< [m/s]; 0 without impacts
  double share_at_rest;        ///< of the time, in [0, 1]
};

/// A range of speeds in which a motion keeps its period, its collisions per turn, and whether it
/// rests.
struct Regime {
  double from, to;             ///< [rad/s]
  double collisions_per_turn;  ///< mean; exact where nothing disturbs the carrier
  /// Collisions in a turn over the phase of a disturbance that does not repeat, of which turns at
  /// less than one phase in some thousands may be missed; else both are the mean.
  double least_per_turn, most_per_turn;
  LongRun first, last;  ///< at both ends
  int turns;            ///< of one period; 0 if the motion does not repeat
  bool rests;           ///< comes to rest in every period
  bool moves;           ///< false: friction holds the carrier
  /// False if the motion does not repeat within some hundred turns: the numbers are averages, and
  /// borders within the regime may be missed. False too for a periodic motion in a range narrower
  /// than 2 % between motions that are not certain, and where a motion jumps within a step of 1e-7:
  /// others may lie between. False where a TimeLimit ended the search; under a disturbance also for
  /// the regimes before, since later ones may tell of borders there.
  bool certain;
  /// The largest modulus of the eigenvalues of a period: how much of a small disturbance is left
  /// after it, at the regime's fast end. 0 where a rest on a wall erases memory.
  double memory;
  RegimeEnd ends_by;
};

/// Allowed speeds [rad/s].
inline constexpr double slowest_regime = 1e-3;
inline constexpr double fastest_regime = 1000;

struct RegimeOptions {
  double from = 0.01;  ///< [rad/s]
  double to = 18;      ///< [rad/s], > from
};

/// Whether regimes_of() knows the regimes of such a scene: hard walls in one direction, the rule of
/// impacts, a constant speed.
bool has_regimes(const Scene& scene);

/// Throws InputError, with one line that begins with `origin`, if regimes_of() knows no regimes of
/// such a scene: if the rule is not `impacts`, or the fidelity neither `impact` nor `auto` (which
/// is taken as impact).
void check_regimes_exist(const Scene& scene, const std::string& origin);

/// Borders nearer to each other than this, relative to the speed, are one: rounding moves a border
/// by some 1e-14, and impacts of equal speed, as on both walls of a machine that is its own mirror
/// image, pass the counting limit at one speed.
inline constexpr double border_resolution = 1e-12;

/// The regimes of a machine in the long run, by increasing speed, without gaps; none is narrower
/// than border_resolution. The carrier starts at the scene's start at the slowest speed, and the
/// speed rises slowly: where several motions are possible at a speed, it keeps the one it has until
/// that ends. The scene's omega and window are not used. If a TimeLimit is reached, the last regime
/// ends by it, before options.to. Throws InputError if the scene or an option is invalid, if the
/// speed is a profile, or as check_regimes_exist() does; TimeLimitReached if not even the motion at
/// options.from is known.
std::vector<Regime> regimes_of(const Scene& scene, const RegimeOptions& options = {});

/// The most collisions in a turn in the long run at the scene's constant speed; the mean where the
/// motion does not repeat. `scene` must be valid, with regimes.
double most_per_turn(const Scene& scene);

/// The fastest speed [rad/s] up to which no turn in the long run has more than `at_most`
/// collisions: the end of the last such regime, before the first that is louder. Nothing if the
/// first regime is louder; options.to if none is. Throws TimeLimitReached if that is not known.
std::optional<double> quiet_up_to(const Scene& scene, double at_most,
                                  const RegimeOptions& options = {});

/// A motion that carriers settle on, and how many of the sampled starts lead to it.
struct Basin {
  LongRun motion;  ///< of the first such start; averages where the motion does not repeat
  int turns;       ///< of one period; 0 if the motion does not repeat
  int starts;
};

struct BasinOptions {
  int starts = 1000;       ///< 1..10,000,000
  std::uint64_t seed = 1;  ///< of the random starts
  /// [m], highest start above the lower wall; if missing: the clearance, which must be finite.
  std::optional<double> height = {};
  /// [m/s], fastest start; if missing: the largest of the scene's own start velocity, of the
  /// fastest impact in its long run, and of height times speed.
  std::optional<double> fastest = {};
};

/// The motions between which starts divide.
struct Basins {
  double height, fastest;     ///< [m], [m/s], of the sampled starts
  int starts;                 ///< sampled: as many as asked for, unless a TimeLimit was reached
  std::vector<Basin> basins;  ///< the most frequent first
};

/// Samples starts of a machine at its constant speed, position, velocity (both signs) and phase
/// uniform, and lets each settle. Motions with the same period, collisions, energy, fastest impact
/// and share at rest, all to 1e-6, are one, as mirror images are; all that do not repeat are one.
/// The same seed gives the same starts. Throws InputError if the scene or an option is invalid, if
/// a disturbance does not repeat within 16 turns, or as check_regimes_exist() does;
/// TimeLimitReached if no start has settled by then. In parallel.
Basins basins_of(const Scene& scene, const BasinOptions& options = {});

}  // namespace ricochet::carrier_track::inline regimes

/// @file
/// Collision counts over a range of speeds, and the fastest quiet speed.
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
