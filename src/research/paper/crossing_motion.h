#pragma once

#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline paper {

/// Speed and acceleration prescribed by the track, equations (1)-(5), Figure 3.
struct TheoreticalMotion {
  double speed;         ///< [m/s]
  double acceleration;  ///< [m/s^2]
};

/// On the circular arcs BE and FD, equations (1)-(2): r w and r w^2.
TheoreticalMotion on_arc(double radius, double omega);

/// On the straight crossing EF, equations (3)-(5). `angle` = phi_2 - phi_1 in (-pi/2, pi/2) [rad]
/// is the angle of the driving plate from the point where the crossing is tangent to its arc: it
/// rises from 0 until the next plate takes over half way, and then runs from the negative back to
/// 0. Equation (5) agrees with (4) only if the normal and tangential parts enclose 90 degrees +
/// angle; this reading is used here.
TheoreticalMotion on_crossing(double radius, double omega, double angle);

/// The normal and tangential parts of equation (4) [m/s^2] on the crossing.
struct CrossingParts {
  double normal;      ///< r w^2 / cos(angle)
  double tangential;  ///< dV/dt = 2 r w^2 sin(angle) / cos^3(angle)
};
CrossingParts crossing_parts(double radius, double omega, double angle);

/// The speed [rad/s] of a carrier about its plate's axis, V / r of equations (1) and (3), while the
/// plate turns steadily at `omega` [rad/s] > 0: the middle of every half turn of the plate has a
/// crossing, where the plate turns from -`angle` to +`angle` in (0, pi/4) [rad]; there the speed
/// rises to omega / cos^2(angle) half way. Five knots per crossing approximate that curve. The
/// profile covers `turns`.
std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns);

}  // namespace ricochet::carrier_track::inline paper
