#pragma once

#include <vector>

namespace ricochet {

struct RankSumTest {
  double smaller;  ///< P(a < b) + P(a = b) / 2: how often a value of a is below one of b
  double p_value;  ///< two-sided
};

/// Mann and Whitney's rank-sum test of the hypothesis that two samples have the same distribution
/// (1947, doi:10.1214/aoms/1177730491). Equal values share their rank. With at most 60 values in
/// all the p-value is exact given the ties: the share of all divisions into samples of these sizes
/// whose rank sum is at least as far from its mean. With more values it uses the normal
/// approximation, corrected for ties and for continuity. Infinite values, never reached, are equal
/// and the largest. The measure `smaller` is that of Vargha and Delaney (2000,
/// doi:10.3102/10769986025002101). Throws std::invalid_argument for an empty sample or a value that
/// is no number.
RankSumTest rank_sum_test(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ricochet
