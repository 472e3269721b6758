#pragma once

#include <vector>

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

struct MeanShare {
  double mean;
  Interval interval;
};

/// Mean of independent values in [0, 1], one for each problem, with its interval: Wilson's, for the
/// number of trials that would have the same variance (Korn and Graubard 1998, Survey Methodology
/// 24, 193, do this with the exact interval). A pseudo-observation of a tenth of a problem is added
/// at either end; without it a few problems that happen to agree would look certain. In simulations
/// with many kinds of problems, a nominal 95 % gave a coverage of 97 % with 12 problems and 96 %
/// with 20 or 50, and never less than 92 %; a percentile bootstrap over the problems gave 80 % with
/// 10 and 87 % with 20. Throws std::invalid_argument for no values or one outside [0, 1].
MeanShare mean_share(const std::vector<double>& shares, double confidence = 0.95);

}  // namespace ricochet
