#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// What stands for the margin of an impact that is not there, or slower.
inline constexpr double lowest_margin = -6;

/// One turn of the driver plate under a disturbance.
struct DisturbedTurn {
  double phase;                 ///< [rad], of the disturbance at the start of the motion before
  std::vector<Impact> impacts;  ///< by time, those of margins above lowest_margin
  std::vector<double> speeds;   ///< [m/s], of these, the fastest first
  int collisions;
  double end_position = 0;            ///< [m]
  double end_velocity = 0;            ///< [m/s]
  bool returns = false;               ///< the carrier ends at rest where it started
  std::optional<Wall> rests_on = {};  ///< the wall on which it ends at rest
};

/// The turns that follow on `before` turns from the start of a valid scene of fidelity impact, for
/// these phases [rad] of its disturbance. Side by side, and without the last of a series of
/// rebounds: impacts are exact where the carrier rests before it moves again.
std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before);

/// The same of any such scenes that differ in their speed and in the phase of their disturbance.
std::vector<DisturbedTurn> turns_of(std::span<const Scene> scenes, int before);

/// ln(speed / counting limit) of the rank-th fastest impact of a turn, rank 1 the fastest. At least
/// lowest_margin.
double margin_of(const Scene& scene, const DisturbedTurn& turn, int rank);

// The motion of a machine in the long run under a disturbance that does not repeat with the driver
// plate. In every turn the disturbance has another phase; over many turns all phases are equally
// frequent.

/// Which of the phases a margin is taken at.
enum class Extreme { least, most };

/// 1 or -1: makes the extreme the least.
inline double sign_of(Extreme extreme) {
  return extreme == Extreme::least ? 1 : -1;
}

/// A margin that was searched before.
struct KnownMargin {
  int rank;
  Extreme extreme;
  double value;
  double phase;  ///< [rad]
};

struct DisturbedMotion {
  /// At the speed; it starts at rest on a wall, where every turn starts, or `turns_before` turns
  /// earlier, whose rests erase the start.
  Scene machine;
  int turns_before = 0;
  bool settled =
      true;  ///< a turn depends on its phase alone, because a rest erases what was before
  bool moves = true;
  double first_phase = 0;  ///< [rad], of the evenly spaced ones
  /// Over evenly spaced phases. If not settled, none before observe(), then successive ones.
  std::vector<DisturbedTurn> turns = {};
  /// Turns with fewer or more collisions than those, at phases next to which no even phase is.
  std::vector<DisturbedTurn> watched = {};
  int least = 0, most = 0;  ///< collisions in a turn, over all phases

  mutable std::vector<KnownMargin> known = {};  ///< of these turns

  double omega() const { return machine.omega; }
};

/// Whether a force of its own frequency shakes the carrier: a disturbance of frequency 0 is
/// constant.
inline bool is_disturbed(const Scene& scene) {
  return scene.disturbance != 0 && scene.disturbance_frequency != 0;
}

/// The motion of a valid scene of fidelity impact at its constant speed > 0, with forcing_turns 0.
DisturbedMotion disturbed_motion(const Scene& scene);

/// Lets the turns of the plate begin where its force passes zero from above: a carrier that rests
/// in every half turn then rests.
void begin_turns_at_rest(Scene& scene);

/// The same at another speed [rad/s], near that of `motion`; at other even phases, and at those at
/// which `motion` has its fewest and its most collisions.
DisturbedMotion followed(const DisturbedMotion& motion, double omega);

/// The phase [rad] at which a motion has the turn that another one, of the same machine near its
/// speed, has at `phase`: they may start other numbers of turns earlier.
double phase_in(const DisturbedMotion& motion, const DisturbedMotion& other, double phase);

/// Lets a motion that is settled watch the turn at another phase [rad].
void watch(DisturbedMotion& motion, double phase);

/// Simulates many turns of a motion that is not settled, and counts them.
void observe(DisturbedMotion& motion);

/// The turn at another phase [rad] of the disturbance, of a motion that is settled.
DisturbedTurn turn_at(const DisturbedMotion& motion, double phase);

/// The machine whose start leads to that turn, at another speed [rad/s].
Scene machine_at(const DisturbedMotion& motion, double omega, double phase);

/// A turn with all that is told of it.
struct ObservedTurn {
  DisturbedTurn turn;
  double energy;         ///< [J], that the walls take
  double share_at_rest;  ///< of the time
};

/// The `turns` turns that follow on `before` turns from the start of a valid scene of fidelity
/// impact, for each of these phases [rad] of its disturbance; simulated to the last rebound.
std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns);

}  // namespace ricochet::carrier_track::inline regimes
