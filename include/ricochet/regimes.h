#pragma once

/// @file
/// The regimes of a machine: what its carrier does in the long run, over the speed.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"

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
