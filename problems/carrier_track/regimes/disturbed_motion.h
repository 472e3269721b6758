#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_turn.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

/// What a carrier does at one speed under a disturbance that does not repeat with the driver plate.
/// In every turn the disturbance has another phase; over many turns all phases are equally
/// frequent. Where a rest erases what was before, a turn depends on its phase alone: turns at many
/// phases, simulated side by side, tell all that happens.
namespace ricochet::carrier_track::inline regimes {

/// A speed [rad/s] and a phase [rad].
struct SpeedAndPhase {
  double omega, phase;
};

struct DisturbedMotion {
  /// At the speed; it starts at rest on a wall, where every turn starts, or `turns_before` turns
  /// earlier, whose rests erase the start.
  Scene machine;
  int turns_before = 0;
  bool settled = true;  ///< a turn depends on its phase alone; see disturbed_motion()
  bool moves = true;
  /// False if more phases than are simulated would be needed to know the fewest and the most.
  bool resolved = true;
  std::vector<DisturbedTurn> turns = {};  ///< by phase, of a motion that is settled and moves
  int least = 0, most = 0;                ///< collisions in a turn, over all phases

  double omega() const { return machine.omega; }
};

/// Which of the phases a margin is taken at.
enum class Extreme { least, most };

/// The turn of a motion in which the margin of that rank is extreme.
const DisturbedTurn& extreme_turn(const DisturbedMotion& motion, int rank, Extreme extreme);

/// Whether a force of its own frequency shakes the carrier: a disturbance of frequency 0 is
/// constant.
inline bool is_disturbed(const Scene& scene) {
  return scene.disturbance != 0 && scene.disturbance_frequency != 0;
}

/// The motion of a valid scene of fidelity impact at its constant speed > 0, with forcing_turns 0.
/// It is simulated at some phases; unless these turns are alike, at more phases, at those in `also`
/// [rad], and between phases whose turns differ so much that turns with fewer or more collisions
/// may hide there, down to 1e-4 rad. It is settled if every turn begins and ends at rest on one
/// wall, also if the carrier is knocked off it, or if starts on both walls (without an upper wall:
/// on the lower one and at rest above it) are forgotten within 32 turns.
DisturbedMotion disturbed_motion(const Scene& scene, std::span<const double> also = {});

/// The turns of a settled motion at another speed [rad/s] and at other phases.
std::vector<DisturbedTurn> turns_of(const DisturbedMotion& motion,
                                    std::span<const SpeedAndPhase> places);

/// The turns that are observed of a motion that does not settle, one after the other.
std::vector<ObservedTurn> irregular_turns(const DisturbedMotion& motion);

/// Over the phases; energy and rest are those of eight. If it is not settled, of irregular_turns().
LongRun long_run_of(const DisturbedMotion& motion);

/// The collisions in a turn at one speed, as simulated from some phases of the disturbance: turns
/// that fewer phases have are missed.
struct SampledTurns {
  double omega;  ///< [rad/s]
  double mean_per_turn;
  int most_per_turn;
};

inline constexpr int sampled_phases = 24;
inline constexpr int sampled_turns_each = 20;  ///< after as many to settle

/// Simulates turns of a valid scene with regimes (has_regimes) at speeds [rad/s] with equal ratios,
/// from `from` to `to`, both included. If a TimeLimit is reached, or a simulation has too many
/// impacts, the slower speeds are missing.
std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to);

}  // namespace ricochet::carrier_track::inline regimes
