#pragma once

#include "src/statistics/interval.h"

namespace ricochet {

/// Wilson's score interval of a probability after `successes` of `trials` >= 1 (Wilson 1927,
/// doi:10.1080/01621459.1927.10502953): all p for which the share lies within z sqrt(p (1 - p) / n)
/// of p. Never empty, never outside [0, 1], and of the right coverage on average over p (Brown, Cai
/// and DasGupta 2001, doi:10.1214/ss/1009213286); near 0 and 1 that of some p is lower. Both counts
/// may be fractions, as effective sample sizes are. Throws std::invalid_argument for counts that do
/// not fit.
Interval wilson_interval(double successes, double trials, double confidence = 0.95);

}  // namespace ricochet
