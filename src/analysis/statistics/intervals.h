#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ricochet {

/// A closed interval; the upper end may be infinite.
struct Interval {
  double lower, upper;
};

/// Throws std::invalid_argument unless the confidence is in (0, 1).
inline void check_confidence(double confidence) {
  if (!(confidence > 0 && confidence < 1)) {
    throw std::invalid_argument("the confidence must be in (0, 1)");
  }
}

/// Wilson's score interval of a probability after `successes` of `trials` >= 1 (Wilson 1927,
/// doi:10.1080/01621459.1927.10502953): all p for which the share lies within z sqrt(p (1 - p) / n)
/// of p. Never empty, never outside [0, 1]. Its coverage is right on average over p, but lower for
/// some p near 0 and 1 (Brown, Cai and DasGupta 2001, doi:10.1214/ss/1009213286). Both counts may
/// be fractions, e.g. effective sample sizes. Throws std::invalid_argument for invalid counts.
Interval wilson_interval(double successes, double trials, double confidence = 0.95);

struct MeanShare {
  double mean;
  Interval interval;
};

/// Mean of values in [0, 1], one for each problem, with its interval: Wilson's, for the number of
/// trials that would have the same variance (Korn and Graubard 1998, Survey Methodology 24, 193, do
/// this with the exact interval). The variance is that between clusters: `clusters` names that of
/// each problem, whose values are alike, and if it is empty, all are independent. If problems share
/// clusters, the number is reduced by what Student's t takes. A pseudo-observation of a tenth of a
/// cluster is added at either end; without it a few clusters that happen to agree would look
/// certain. In simulations with independent problems, a nominal 95 % gave a coverage of 97 % with
/// 12 and 96 % with 20 or 50; with 4 to 60 clusters of one to five like problems 94 to 100 %, where
/// it was 74 to 93 % if all were taken for independent. Throws std::invalid_argument for no values,
/// one outside [0, 1], or another number of clusters.
MeanShare mean_share(const std::vector<double>& shares,
                     const std::vector<std::string>& clusters = {}, double confidence = 0.95);

/// The places of each cluster's problems, clusters in the order of their first problems; a problem
/// whose cluster has no name is alone in one.
std::vector<std::vector<std::size_t>> places_by_cluster(const std::vector<std::string>& clusters);

/// How many independent problems would give the mean of these shares the variance that the clusters
/// give it, at most as many as there are; for several entries the variances are summed. `entries`
/// has the shares of each entry, one for each problem.
double effective_problems(const std::vector<std::vector<double>>& entries,
                          const std::vector<std::string>& clusters);

/// How often the interval of mean_share() of a sample of the clusters, drawn with replacement, has
/// the mean over all problems, for these entries together. `known`: whether mean_share() is told
/// the clusters. Deterministic in `seed`.
double coverage_of_mean_share(const std::vector<std::vector<double>>& entries,
                              const std::vector<std::string>& clusters, bool known,
                              std::uint64_t seed, int samples = 200);

/// Quantile q in [0, 1] of the sample, linear between neighbours (Hyndman and Fan 1996, type 7).
/// Infinite values are allowed and sorted last. The sample must not be empty.
double quantile(std::vector<double> sample, double q);

/// Square root of the mean of the squares. The sample must not be empty.
double root_mean_square(const std::vector<double>& errors);

/// Percentile bootstrap interval of the root mean square of errors, from `resamples` samples of as
/// many groups, drawn whole and with replacement. Errors that are independent are groups of one.
/// With few groups it is too narrow rather than too wide. Deterministic in `seed`. There must be a
/// group, and none without an error.
Interval root_mean_square_interval(const std::vector<std::vector<double>>& groups,
                                   double confidence, int resamples, std::uint64_t seed);

}  // namespace ricochet
