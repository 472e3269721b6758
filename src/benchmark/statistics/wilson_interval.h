#pragma once

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// Wilson's score interval of a probability after `successes` of `trials` >= 1 (Wilson 1927,
/// doi:10.1080/01621459.1927.10502953): all p for which the share lies within z sqrt(p (1 - p) / n)
/// of p. Never empty, never outside [0, 1]. Its coverage is right on average over p, but lower for
/// some p near 0 and 1 (Brown, Cai and DasGupta 2001, doi:10.1214/ss/1009213286). Both counts may
/// be fractions, e.g. effective sample sizes. Throws std::invalid_argument for invalid counts.
Interval wilson_interval(double successes, double trials, double confidence = 0.95);

}  // namespace ricochet
