#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// Spearman's rank correlation of two samples of the same length >= 2, in [-1, 1]: Pearson's
/// correlation of their ranks, where equal values share their mean rank. Nothing if a sample is
/// constant. Throws std::invalid_argument for samples that do not fit.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// Kendall's tau-b of the samples: the number of concordant less discordant pairs over the
/// geometric mean of the numbers of pairs that are not tied in the first and in the second sample
/// (Kendall 1945, doi:10.1093/biomet/33.3.239).
std::optional<double> kendall_rank_correlation(const std::vector<double>& a,
                                               const std::vector<double>& b);

/// Interval of Kendall's tau of `size` >= 5 independent pairs, by Fisher's transformation with the
/// variance 0.437 / (size - 4) (Fieller, Hartley and Pearson 1957, doi:10.1093/biomet/44.3-4.470).
/// Uses Student's t in place of the normal quantile, which with 12 pairs would cover 93 % instead
/// of 95 %. Valid for correlations up to about 0.8; at 1 and -1 the interval has length 0. Throws
/// std::invalid_argument for arguments out of range.
Interval kendall_interval(double correlation, std::size_t size, double confidence = 0.95);

}  // namespace ricochet
