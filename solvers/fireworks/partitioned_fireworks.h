#pragma once

#include <string>

#include "ricochet/solver.h"

namespace ricochet::fireworks {

/// The defaults are those of the authors' program.
struct PartitionedFireworksOptions {
  int fireworks = 5;
  int sparks = 60;               ///< of each firework, in each generation
  double initial_scale = 0.025;  ///< standard deviation of a new firework's sparks; box widths, > 0
  int patience = 20;  ///< generations without improvement after which a firework restarts
};

/// FWASSP, the fireworks algorithm based on search space partition (Li and Tan, ICSI 2021, doi
/// 10.1007/978-3-030-78743-1_41), which HCFWA extends. Every firework draws its sparks from a
/// normal distribution that adapts as in CMA-ES. After each generation the surfaces of the
/// distributions are drawn towards points between each two fireworks, so that they neither overlap
/// nor leave gaps: towards the middle of the gap, or, where all sparks of one are better than all
/// of the other, to the surface of the better one. A firework restarts uniformly in the box where
/// its sparks' values or its distribution have no width (1e-6, and 5e-9 box widths), where it
/// waited too long, or where a better one's surface holds more than 85 % of its better sparks.
///
/// Equations and numbers are those of the authors' public program (2021). Its lengths are in a box
/// 200 wide; here they are in box widths. What it leaves open, or is different here: at most two
/// points, the nearest, are fitted for every firework, where the program takes the farthest for the
/// first; a firework that is as good as another in every pair is not better; points that are not
/// feasible rank by better(); the first firework begins at the start. Continues until the evaluator
/// refuses. Throws std::invalid_argument for options out of range.
Solver partitioned_fireworks(std::string name, const PartitionedFireworksOptions& options = {});

/// Where a firework's surface is to be, towards another firework whose mean is `apart` away: its
/// distance from the mean in units of `radius`, where it is now. Two fireworks share the gap (or
/// the overlap) between their surfaces; one that fits `alone` takes all of it. Between 1/2 and 2 in
/// size; negative if the other surface reaches beyond this mean.
double fitted_radius(double apart, double radius, double other_radius, bool alone);

}  // namespace ricochet::fireworks
