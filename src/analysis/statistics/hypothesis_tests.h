#pragma once

#include <cstdint>
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

/// Number of successes and trials; 0 <= successes <= trials.
struct Share {
  int successes, trials;
};

/// Two-sided p-value of the hypothesis that both shares have the same probability: the probability
/// of all tables with the same margins that are not likelier than the observed one (Fisher 1934; as
/// in R and SciPy). Exact given the margins, and therefore conservative. Throws
/// std::invalid_argument for invalid counts.
double fisher_exact_test(Share a, Share b);

/// Posterior probabilities that differences are mostly negative, practically 0, or positive; their
/// sum is 1.
struct SignedRankPosterior {
  double negative, equivalent, positive;
};

/// Bayesian signed-rank test of differences A - B, one for each problem, with a region of practical
/// equivalence [-rope, rope], closed. The shares of pairs whose mean is below, in and above it have
/// a posterior, from a Dirichlet process with a prior observation of 0 that weighs half a problem.
/// The result is the probability that each of the three shares is the largest (Benavoli, Corani,
/// Demšar and Zaffalon 2017, Journal of Machine Learning Research 18(77),
/// https://jmlr.org/papers/v18/16-305.html, section 4.2). For counts, use rope = 0.5. An infinite
/// difference outweighs all finite ones. Uses 20,000 draws, deterministic in `seed`; results of
/// different seeds differ by 0.01. Throws std::invalid_argument for a difference that is no number,
/// or a rope that is negative or infinite.
SignedRankPosterior bayesian_signed_rank(const std::vector<double>& differences, double rope,
                                         std::uint64_t seed);

/// p-values of a family of tests, adjusted so that the probability of rejecting any true hypothesis
/// stays below the level, whatever the dependence between the tests (Holm 1979, Scandinavian
/// Journal of Statistics 6, 65, https://www.jstor.org/stable/4615733). In the order given. Throws
/// std::invalid_argument for a value outside [0, 1].
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace ricochet
