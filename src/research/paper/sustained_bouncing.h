#pragma once

#include <optional>

#include "ricochet/scene.h"

/// The least drive that keeps a body bouncing on one wall, in closed form. A body that is pulled
/// onto a wall and driven by a force A cos(angle), whose angle turns evenly, can hit the wall once
/// a turn, always at the same angle and speed. The drive must replace the losses at impacts and by
/// friction, so there is a least amplitude A, below which this motion does not exist.
///
/// Without friction A = pi pull (1 - e) / (1 + e), where e is the restitution. Over one turn the
/// momentum of the pull equals the change at the impact, so that the body departs at 2 pi e pull /
/// ((1 + e) mass omega). The condition that it is back on the wall after the turn gives A sin(angle
/// of departure) = -pi pull (1 - e) / (1 + e), and a sine is at least -1.
///
/// Coulomb friction adds to the pull on the way up and subtracts from it on the way down, so both
/// balances depend on the angle by which the drive turns until the body is at the top. The velocity
/// is zero there, which is a third equation. The three give A as a function of that turning angle,
/// in closed form; the least A is where its derivative, also in closed form, is zero.
///
/// Assumptions: friction smaller than the pull, no halt on the way up or down, and a flight that
/// stays below the other wall. Below the limit a body comes to rest if the drive cannot lift it
/// (lift_off_speed); otherwise it is thrown again every turn, with halts on the wall or in the air.
namespace ricochet::carrier_track::inline paper {

/// The motion at its limit. `omega` [rad/s] is the speed at which the drive turns.
struct SustainedBouncing {
  double force;            ///< [N], the least amplitude of the drive
  double departure_angle;  ///< [rad], of the drive when the body leaves the wall, in [-pi, pi]
  double turning_angle;    ///< [rad], by which it has turned since, when the body is at the top
  double departure_speed;  ///< [N], mass omega times the speed at departure [m/s]
  double height;           ///< [N], mass omega^2 times the height [m]
};

/// For a body pulled [N] onto a wall with friction_force [N] in flight. Nothing unless 0 <=
/// friction_force < pull and 0 < restitution < 1, or if the restitution is so low (below about
/// 0.03) that the drive would turn more than once per flight.
std::optional<SustainedBouncing> sustained_bouncing(double pull, double friction_force,
                                                    double restitution);

/// For the scene's parameters on its lower wall; its speed, upper wall and disturbance have no
/// effect. Also nothing if pull or centrifugal force are not as assumed (a pull that rotates, a
/// centrifugal force that does not).
std::optional<SustainedBouncing> sustained_bouncing(const Scene& scene);

/// The speed [rad/s] from which the scene's drive sustains bouncing, without an upper wall. Nothing
/// if sustained_bouncing returns nothing or if there is no drive.
std::optional<double> sustained_bouncing_speed(const Scene& scene);

/// Height [m] to which the body rises at that speed.
std::optional<double> sustained_bouncing_height(const Scene& scene);

/// The speed [rad/s] from which the drive lifts a body that rests on the lower wall: its amplitude
/// is pull + friction_force. Nothing if pull or centrifugal force are not as above, if the pull is
/// not > 0, or if there is no drive.
std::optional<double> lift_off_speed(const Scene& scene);

}  // namespace ricochet::carrier_track::inline paper
