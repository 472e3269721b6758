#pragma once

#include <vector>

#include "problems/carrier_track/regimes/disturbed_turn.h"
#include "ricochet/scene.h"

/// The motion of a machine in the long run under a disturbance that does not repeat with the driver
/// plate. In every turn the disturbance has another phase; over many turns all phases are equally
/// frequent.
namespace ricochet::carrier_track::inline regimes {

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

}  // namespace ricochet::carrier_track::inline regimes
