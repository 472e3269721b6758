#pragma once

#include "problems/carrier_track/paper/open_constants.h"

/// Two exact symmetries of equation (31) without disturbance, of readings whose centrifugal force
/// is projected, whose tension is constant, and whose window is a number of turns. They say how
/// much of the open constants the thresholds of C1..C4 can depend on at all.
namespace ricochet::studies::limits {

/// Forces, clearance, start velocity and slowest impact times the factor: the motion is as many
/// times larger, and every count is the same at the same speed.
carrier_track::Constants scaled_in_space(const carrier_track::Constants& constants, double factor);

/// Forces by the square of the factor, start velocity and slowest impact by the factor: every count
/// is the same at so many times the speed.
carrier_track::Constants scaled_in_time(const carrier_track::Constants& constants, double factor);

/// How many counts of C1..C4 stay the same under a symmetry.
struct SymmetryCheck {
  int counts = 0;  ///< that were compared
  int alike = 0;
};

/// Compares both at random constants of the reading and random speeds, for each of so many.
struct SymmetryChecks {
  double factor;
  SymmetryCheck space, time;
};
SymmetryChecks check_symmetries(const carrier_track::Reading& reading, double factor, int draws,
                                std::uint64_t seed);

}  // namespace ricochet::studies::limits
