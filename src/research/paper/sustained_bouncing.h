#pragma once

#include <optional>

#include "problems/carrier_track/scene/scene.h"

/// The least drive that keeps a body bouncing on one wall, in closed form. A body that is pulled
/// onto a wall and driven by a force A cos(angle), whose angle turns evenly, can strike the wall
/// once a turn, always at the same angle and speed. The drive has to make up for what impacts and
/// friction take, so there is a least amplitude A, below which this motion does not exist.
///
/// Without friction A = pi pull (1 - e) / (1 + e), where e is the restitution. Over one turn the
/// pull's momentum is what the impact turns back, so that the body departs at
/// 2 pi e pull / ((1 + e) mass omega). That it is back on the wall after the turn then says
/// A sin(angle of departure) = -pi pull (1 - e) / (1 + e), and no sine is beyond -1.
///
/// Coulomb friction adds to the pull on the way up and takes from it on the way down, so both
/// balances depend on the angle by which the drive turns until the body is at the top. That the
/// velocity is zero there is a third equation. The three give A as a function of that turning
/// angle, in closed form; the least A is where its derivative, a closed form too, is zero.
///
/// Assumed: friction smaller than the pull, no halt on the way up or down, and a hop that stays
/// below the other wall. Below the limit a body comes to rest if the drive cannot lift it
/// (lift_off_speed); else it is thrown anew every turn, with halts on the wall or in the air.
namespace ricochet::carrier_track::inline paper {

/// The motion at its limit. `omega` [rad/s] is the speed at which the drive turns.
struct SustainedBouncing {
  double force;            ///< [N], the least amplitude of the drive
  double departure_angle;  ///< [rad], of the drive when the body leaves the wall, in [-pi, pi]
  double turning_angle;    ///< [rad], by which it has turned since when the body is at the top
  double departure_speed;  ///< [N], times mass omega: leaves the wall with it / (mass omega) [m/s]
  double height;           ///< [N], times mass omega^2: rises by it / (mass omega^2) [m]
};

/// Of a body pulled [N] onto a wall and held back by friction_force [N] in flight. Nothing unless
/// 0 <= friction_force < pull and 0 < restitution < 1, or where the restitution is so low (below
/// about 0.03) that the body would turn more than once.
std::optional<SustainedBouncing> sustained_bouncing(double pull, double friction_force,
                                                    double restitution);

/// Of the scene's constants on its lower wall; its speed, upper wall and disturbance do not matter.
/// Nothing, too, where pull or centrifugal force are not as assumed (a pull that rotates, a
/// centrifugal force that does not).
std::optional<SustainedBouncing> sustained_bouncing(const Scene& scene);

/// The speed [rad/s] from which the scene's drive sustains bouncing, as if there were no upper
/// wall. Nothing where sustained_bouncing has nothing or nothing drives.
std::optional<double> sustained_bouncing_speed(const Scene& scene);

/// How high [m] the body rises at that speed.
std::optional<double> sustained_bouncing_height(const Scene& scene);

/// The speed [rad/s] from which the drive lifts a body that rests on the lower wall: its amplitude
/// is pull + friction_force. Nothing where pull or centrifugal force are not as above, the pull is
/// not > 0, or nothing drives.
std::optional<double> lift_off_speed(const Scene& scene);

}  // namespace ricochet::carrier_track::inline paper
