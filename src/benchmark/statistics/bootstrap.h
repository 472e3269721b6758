#pragma once

#include <cstdint>
#include <vector>

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// Quantile q in [0, 1] of the sample, linear between neighbours (Hyndman and Fan 1996, type 7).
/// Infinite values are allowed and sorted last. The sample must not be empty.
double quantile(std::vector<double> sample, double q);

/// Percentile bootstrap interval of the median at `confidence` in (0, 1), from `resamples` samples
/// drawn with replacement (Efron 1979, doi:10.1214/aos/1176344552). For bands along a curve. With
/// 15 values the coverage is 91 % instead of 95 %; order_statistic_interval() never covers less
/// than its confidence. Deterministic in `seed`. The sample must not be empty.
Interval median_interval(const std::vector<double>& sample, double confidence, int resamples,
                         std::uint64_t seed);

}  // namespace ricochet
