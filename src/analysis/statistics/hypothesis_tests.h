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

/// Number of successes and trials; 0 <= successes <= trials.
struct Share {
  int successes, trials;
};

/// Two-sided p-value of the hypothesis that both shares have the same probability: the probability
/// of all tables with the same margins that are not likelier than the observed one (Fisher 1934; as
/// in R and SciPy). Exact given the margins, and therefore conservative. Throws
/// std::invalid_argument for invalid counts.
double fisher_exact_test(Share a, Share b);

/// p-values of a family of tests, adjusted so that the probability of rejecting any true hypothesis
/// stays below the level, whatever the dependence between the tests (Holm 1979, Scandinavian
/// Journal of Statistics 6, 65, https://www.jstor.org/stable/4615733). In the order given. Throws
/// std::invalid_argument for a value outside [0, 1].
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace ricochet
