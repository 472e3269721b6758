#pragma once

#include <vector>

namespace ricochet {

/// Two-sided p-value of Wilcoxon's signed-rank test of the hypothesis that the differences within
/// pairs are symmetric about 0 (1945, doi:10.2307/3001968). Differences of 0 are ranked with the
/// others and then left out (Pratt 1959, doi:10.1080/01621459.1959.10501526); equal ones share
/// their rank. With at most 200 differences it is exact given the ties, over all choices of the
/// signs; with more it uses the normal approximation, corrected for continuity. Infinite
/// differences are allowed; if neither of a pair reached its target, the difference is 0. Throws
/// std::invalid_argument for a difference that is no number.
double signed_rank_test(const std::vector<double>& differences);

}  // namespace ricochet
