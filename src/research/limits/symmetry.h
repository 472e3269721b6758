#pragma once

#include "src/research/paper/unknown_parameters.h"

/// Two exact symmetries of equation (31) without disturbance, for interpretations with projected
/// centrifugal force, constant tension, and a window in turns. They limit how many combinations of
/// the unknown parameters the thresholds of C1..C4 can depend on.
namespace ricochet::studies::limits {

/// Multiplies forces, clearance, start velocity and counting limit by the factor: the motion is
/// scaled by it, and every count is the same at the same speed.
carrier_track::Constants scaled_in_space(const carrier_track::Constants& constants, double factor);

/// Multiplies forces by the square of the factor, start velocity and counting limit by the factor:
/// every count is the same at the speed times the factor.
carrier_track::Constants scaled_in_time(const carrier_track::Constants& constants, double factor);

/// Number of counts of C1..C4 that stay the same under a symmetry.
struct SymmetryCheck {
  int counts = 0;  ///< compared in total
  int alike = 0;
};

/// Compares both at this number of random parameter sets of the interpretation and random speeds.
struct SymmetryChecks {
  double factor;
  SymmetryCheck space, time;
};
SymmetryChecks check_symmetries(const carrier_track::Interpretation& interpretation, double factor,
                                int draws, std::uint64_t seed);

}  // namespace ricochet::studies::limits
