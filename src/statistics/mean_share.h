#pragma once

#include <vector>

#include "src/statistics/interval.h"

namespace ricochet {

struct MeanShare {
  double mean;
  Interval interval;
};

/// Mean of independent values in [0, 1], one a question, with its interval: Wilson's, for as many
/// trials as would vary as much (Korn and Graubard 1998, Survey Methodology 24, 193, do so with the
/// exact one). A tenth of a question at either end is imagined beside them, without which a few
/// questions that happen to agree look certain. Simulated with questions of many kinds, 95 % are 97
/// % with 12 questions and 96 % with 20 or 50, and never less than 92 %; a percentile bootstrap
/// over the questions covers 80 % with 10 and 87 % with 20. Throws std::invalid_argument for no
/// values or one outside [0, 1].
MeanShare mean_share(const std::vector<double>& shares, double confidence = 0.95);

}  // namespace ricochet
