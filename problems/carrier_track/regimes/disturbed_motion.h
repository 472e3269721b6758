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

/// A margin that was searched before.
struct KnownMargin {
  int rank;
  Extreme extreme;
  double value;
};

struct DisturbedMotion {
  /// At the speed; it starts at rest on a wall, where every turn starts, or `turns_before` turns
  /// earlier, whose rests erase the start.
  Scene machine;
  int turns_before;
  bool settled;  ///< a turn depends on its phase alone, because a rest erases what was before
  bool moves;
  /// Over evenly spaced phases. If not settled, none before observe(), then successive ones.
  std::vector<DisturbedTurn> turns;
  int least, most;  ///< collisions in a turn, over all phases

  mutable std::vector<KnownMargin> known;  ///< of these turns

  double omega() const { return machine.omega; }
};

/// Whether a force of its own frequency shakes the carrier: a disturbance of frequency 0 is
/// constant.
inline bool is_disturbed(const Scene& scene) {
  return scene.disturbance != 0 && scene.disturbance_frequency != 0;
}

/// The motion of a valid scene of fidelity impact at its constant speed > 0, with forcing_turns 0.
DisturbedMotion disturbed_motion(const Scene& scene);

/// Simulates many turns of a motion that is not settled, and counts them.
void observe(DisturbedMotion& motion);

/// The turn at another phase [rad] of the disturbance, of a motion that is settled.
DisturbedTurn turn_at(const DisturbedMotion& motion, double phase);

/// ln(speed / counting limit) of the rank-th fastest impact of a turn, rank 1 the fastest, at the
/// phase at which it is least or most; exact near 0, else by a parabola through three phases. At
/// least lowest_margin.
double rank_margin(const DisturbedMotion& motion, int rank, Extreme extreme);

/// The same by the parabola alone.
double sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme);

/// That margin of motions at other speeds nearby, by a search near the phase at which it was
/// extreme before.
class ExtremeMargin {
 public:
  ExtremeMargin(const DisturbedMotion& motion, int rank, Extreme extreme);

  double at(double omega);

 private:
  DisturbedMotion motion_;
  int rank_;
  double sign_;   // that makes the extreme the least
  double phase_;  // [rad]
};

}  // namespace ricochet::carrier_track::inline regimes
