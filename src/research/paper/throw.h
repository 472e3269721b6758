#pragma once

#include <optional>
#include <vector>

#include "ricochet/recording.h"
#include "ricochet/scene.h"

/// The law of the borders between regimes, in semi-closed form. In every half turn the rotating
/// centrifugal force throws a resting carrier across its clearance; it bounces on the other wall,
/// each time lower, and rests there before the next throw. With r the clearance's own length, theta
/// the angle of the drive, and all forces in units of the drive's amplitude B omega^2, of which
/// friction is phi and a steady force along the throw is p:
///
///   release        cos(theta_0) = phi - p, on the rising side
///   flight         r'' = cos(theta) + p - phi, in closed form, until it crosses the clearance
///   rebound        keeps q = e sqrt((1 - mu) / (1 + mu)) of the speed (q = e if friction does not
///                  multiply the wall's force), against cos(theta) + p + phi on the way off the
///                  wall and with cos(theta) + p - phi on the way back
///   border         as many impacts of both throws as count are as fast as the counting limit.
///
/// Each step is the first zero of an elementary function. So a border depends on few numbers:
/// restitution q, and in units of the drive the clearance m g / B, the friction mu N / (B omega^2),
/// the pull and the counting limit m v / (B omega). Without pull both throws are equal, and a
/// collision more in a throw is two more a turn: at most 2 j a turn ends where the impact after j
/// rebounds passes the limit.
///
/// A disturbance that changes little during a throw is a steady force, in one direction in each of
/// the two throws of a turn, half a turn apart. Beyond a border some turns are louder, if its phase
/// is the worst, or all turns, if even the best is loud.
///
/// Assumptions: projected centrifugal force, equal restitution of both walls, a pull that does not
/// rotate, and a rest on a wall before each throw.
namespace ricochet::carrier_track::inline paper {

/// The speeds [m/s] of at most this number of impacts of a throw towards a wall, by time, at the
/// scene's constant speed, with a steady force [N] towards the upper wall beside the pull. None if
/// the throw does not reach the wall.
std::vector<double> throw_speeds(const Scene& scene, Wall towards, int impacts, double steady = 0);

/// Which turns have more collisions beyond a border.
enum class Louder {
  some,  ///< those of some phases of the disturbance
  all    ///< all
};

/// The speed [rad/s] from which turns have more than `at_most` >= 0 collisions, up to `fastest`.
/// Nothing if they do not.
std::optional<double> throw_border(const Scene& scene, int at_most, Louder louder = Louder::some,
                                   double fastest = 1000);

}  // namespace ricochet::carrier_track::inline paper
