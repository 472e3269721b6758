#pragma once

#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

/// The motion that a machine settles on at a constant speed.
namespace ricochet::carrier_track::inline regimes {

/// Where a motion comes to rest.
enum class Rest {
  never,
  in_the_gap,  ///< friction holds the carrier between the walls
  on_a_wall,   ///< which erases the memory of the motion before
  always       ///< nothing moves
};

/// A periodic motion, with the numbers of one period; or, if `settled` is false, the averages of a
/// long motion that found no period.
struct SteadyMotion {
  /// The machine at the speed of the motion. It starts on the motion, in the middle of the longest
  /// rest or else of the longest flight, and its window is one period.
  Scene orbit;
  bool settled = false;
  int turns = 1;  ///< of the driver plate in one period
  Rest rest = Rest::never;
  std::vector<Impact> impacts;  ///< of one period, by time; slow ones too
  int collisions = 0;           ///< impacts that count, in one period
  double energy = 0;            ///< [J] that the walls take in one period
  double share_at_rest = 0;     ///< of the time, in [0, 1]
  /// Trace and determinant of the Jacobian of the state after one period with respect to the state
  /// before: both 0 where a rest on a wall erases memory; the determinant 0 after a rest between.
  double trace = 0, determinant = 0;

  double omega() const { return orbit.omega; }  ///< [rad/s]
  double collisions_per_turn() const { return static_cast<double>(collisions) / turns; }
  double energy_per_turn() const { return energy / turns; }  ///< [J]
  double fastest_impact() const;                             ///< [m/s]; 0 without impacts

  /// Distance to a period doubling (eigenvalue -1) and to a fold (eigenvalue +1); both are positive
  /// while small disturbances decay.
  double flip_margin() const { return 1 + trace + determinant; }
  double fold_margin() const { return 1 - trace + determinant; }
  bool stable() const { return determinant < 1 && flip_margin() > 0 && fold_margin() > 0; }
};

/// Turns of the driver plate after which all forces of a scene repeat: 1, or up to 16 if the
/// frequency of the disturbance is in such a ratio to the speed; 0 if they do not repeat.
int forcing_turns(const Scene& scene);

/// The motion that a valid scene of fidelity impact settles on from its start, at its constant
/// speed > 0, with forces that repeat (forcing_turns > 0). Follows the motion for at most a few
/// hundred turns, or some 100,000 impacts. The orbit is exact up to rounding: where it rests
/// because the same state comes again, else by Newton's method with exact derivatives.
SteadyMotion steady_motion(const Scene& scene);

/// The motion at another speed [rad/s] that is reached from `motion` if the speed changes slowly:
/// the continuation of the same orbit if there is one, stable or not; else what the carrier settles
/// on from the state of the old orbit.
SteadyMotion followed(const SteadyMotion& motion, double omega);

/// The same for another machine that differs little from that of `motion`; the start of `scene` is
/// not used.
SteadyMotion followed(const SteadyMotion& motion, const Scene& scene);

}  // namespace ricochet::carrier_track::inline regimes
