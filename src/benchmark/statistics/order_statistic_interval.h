#pragma once

#include <optional>
#include <vector>

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// Interval of the quantile q in (0, 1) between two values of the sample, with a coverage of at
/// least `confidence` for any distribution. The ranks follow from the binomial distribution of the
/// number of values below the quantile, each tail at most (1 - confidence) / 2 (David and Nagaraja
/// 2003, Order Statistics, section 7.1, doi:10.1002/0471722162). The median of 15 values is between
/// the 4th and the 12th: 96.5 %. Infinite values, never reached, are the largest, so the upper end
/// may be infinite. Nothing if the sample is too small: a median needs 6 values for 95 %. Throws
/// std::invalid_argument for a value that is no number.
std::optional<Interval> order_statistic_interval(std::vector<double> sample, double q = 0.5,
                                                 double confidence = 0.95);

}  // namespace ricochet
