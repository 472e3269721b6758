#include "src/analysis/statistics/hypothesis_tests.h"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/ranking.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet {

namespace {

constexpr std::size_t most_pairs_for_exact = 200;  // a few million additions

/// Probability that the sum, to which each rank contributes itself or 0 with probability 1/2, is at
/// least as far from its mean as `distance`.
double exact(const std::vector<double>& ranks, double mean, double distance) {
  const auto most = static_cast<std::size_t>(4 * mean);  // twice a rank is an integer
  std::vector<double> chance(most + 1);
  chance[0] = 1;
  for (const double rank : ranks) {
    const auto twice = static_cast<std::size_t>(2 * rank);
    for (std::size_t s = most + 1; s-- > 0;) {
      chance[s] = (chance[s] + (s >= twice ? chance[s - twice] : 0)) / 2;
    }
  }
  double as_far = 0;
  for (std::size_t s = 0; s <= most; ++s) {
    if (std::abs(static_cast<double>(s) / 2 - mean) >= distance) as_far += chance[s];
  }
  return std::min(1.0, as_far);
}

}  // namespace

double signed_rank_test(const std::vector<double>& differences) {
  std::vector<double> sizes;
  for (const double difference : differences) sizes.push_back(std::abs(difference));
  const std::vector<double> all_ranks = ranks_of(sizes);
  std::vector<double> ranks;
  double positive = 0;
  double mean = 0;
  double variance = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (differences[i] == 0) continue;
    ranks.push_back(all_ranks[i]);
    positive += differences[i] > 0 ? all_ranks[i] : 0;
    mean += all_ranks[i] / 2;
    variance += all_ranks[i] * all_ranks[i] / 4;
  }
  if (ranks.empty()) return 1;
  const double distance = std::abs(positive - mean);
  if (ranks.size() <= most_pairs_for_exact) return exact(ranks, mean, distance);
  const double z = std::max(0.0, distance - 0.5) / std::sqrt(variance);
  return std::min(1.0, 2 * cdf(complement(boost::math::normal(), z)));
}

namespace {

constexpr std::size_t most_for_exact = 60;  // a few million additions

/// Share of all choices of `chosen` ranks whose sum is at least as far from `mean` as `distance`.
double exact(const std::vector<double>& ranks, std::size_t chosen, double mean, double distance) {
  // Twice a rank is an integer. ways[j][s]: number of choices of j of the ranks so far whose
  // doubled sum is s.
  const std::size_t most = ranks.size() * (ranks.size() + 1);
  std::vector<std::vector<double>> ways(chosen + 1, std::vector<double>(most + 1));
  ways[0][0] = 1;
  for (const double rank : ranks) {
    const auto twice = static_cast<std::size_t>(2 * rank);
    for (std::size_t j = chosen; j > 0; --j) {
      for (std::size_t s = most; s >= twice; --s) ways[j][s] += ways[j - 1][s - twice];
    }
  }
  double as_far = 0;
  double all = 0;
  for (std::size_t s = 0; s <= most; ++s) {
    all += ways[chosen][s];
    if (std::abs(static_cast<double>(s) / 2 - mean) >= distance) as_far += ways[chosen][s];
  }
  return as_far / all;
}

double normal(const std::vector<double>& ranks, double chosen, double distance) {
  const auto all = static_cast<double>(ranks.size());
  double square = 0;  // of the ranks, around their mean: ties make it smaller
  for (const double rank : ranks) square += std::pow(rank - (all + 1) / 2, 2);
  const double variance = chosen * (all - chosen) * square / (all * (all - 1));
  if (variance == 0) return 1;
  const double z = std::max(0.0, distance - 0.5) / std::sqrt(variance);
  return 2 * cdf(complement(boost::math::normal(), z));
}

}  // namespace

RankSumTest rank_sum_test(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("rank_sum_test: a sample is empty");
  std::vector<double> pooled = a;
  pooled.insert(pooled.end(), b.begin(), b.end());
  const std::vector<double> ranks = ranks_of(pooled);
  const auto end_of_a = ranks.begin() + static_cast<std::ptrdiff_t>(a.size());
  const double sum = std::accumulate(ranks.begin(), end_of_a, 0.0);
  const auto size_a = static_cast<double>(a.size());
  const auto size_b = static_cast<double>(b.size());
  const double mean = size_a * (size_a + size_b + 1) / 2;
  const double distance = std::abs(sum - mean);
  return {.smaller = 0.5 - (sum - mean) / (size_a * size_b),
          .p_value = ranks.size() <= most_for_exact ? exact(ranks, a.size(), mean, distance)
                                                    : normal(ranks, size_a, distance)};
}

double fisher_exact_test(Share a, Share b) {
  for (const Share& share : {a, b}) {
    if (share.successes < 0 || share.successes > share.trials) {
      throw std::invalid_argument("fisher_exact_test: 0 <= successes <= trials is needed");
    }
  }
  const int successes = a.successes + b.successes;
  const int trials = a.trials + b.trials;
  const int first = std::max(0, successes - b.trials);
  const int last = std::min(successes, a.trials);
  if (first == last) return 1;  // this is the only table with these margins
  const boost::math::hypergeometric drawn(static_cast<unsigned>(successes),
                                          static_cast<unsigned>(a.trials),
                                          static_cast<unsigned>(trials));
  // Tables of equal probability count as equally rare despite rounding.
  const double seen = pdf(drawn, a.successes) * (1 + 1e-7);
  double p_value = 0;
  for (int k = first; k <= last; ++k) {
    const double probability = pdf(drawn, k);
    if (probability <= seen) p_value += probability;
  }
  return std::min(1.0, p_value);
}

namespace {

constexpr int draws = 20000;

/// The sorted differences together with the prior's 0, and the index of that 0. An infinite
/// difference is replaced by one so large that its mean with any finite one is beyond the rope.
struct Sample {
  std::vector<double> sorted;
  std::size_t prior;
};

Sample sample_of(const std::vector<double>& differences, double rope) {
  double largest = 0;
  for (const double x : differences) {
    if (std::isnan(x)) throw std::invalid_argument("bayesian_signed_rank: not a number");
    if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  }
  const double beyond = 2 * (largest + rope) + 1;
  Sample sample{{0.0}, 0};
  for (const double x : differences) sample.sorted.push_back(std::clamp(x, -beyond, beyond));
  std::sort(sample.sorted.begin(), sample.sorted.end());
  sample.prior = static_cast<std::size_t>(
      std::lower_bound(sample.sorted.begin(), sample.sorted.end(), 0.0) - sample.sorted.begin());
  return sample;
}

/// For each i, the number of sorted values x_k for which `belongs` accepts x_i + x_k.
template <class Compare>
std::vector<std::size_t> partners(const std::vector<double>& sorted, const Compare& belongs) {
  std::vector<std::size_t> numbers;
  std::size_t k = sorted.size();
  for (const double x : sorted) {
    while (k > 0 && !belongs(x + sorted[k - 1])) --k;
    numbers.push_back(k);
  }
  return numbers;
}

}  // namespace

SignedRankPosterior bayesian_signed_rank(const std::vector<double>& differences, double rope,
                                         std::uint64_t seed) {
  if (!(rope >= 0 && std::isfinite(rope))) {
    throw std::invalid_argument("bayesian_signed_rank: the rope must be >= 0 and finite");
  }
  const auto [sorted, prior] = sample_of(differences, rope);
  const auto below = partners(sorted, [&](double sum) { return sum < -2 * rope; });
  const auto not_above = partners(sorted, [&](double sum) { return sum <= 2 * rope; });
  Random random(seed);
  const Exponential exponential;
  std::vector<double> weights(sorted.size());
  std::vector<double> sums(sorted.size() + 1);  // of the weights before each
  int negative = 0;
  int positive = 0;
  for (int i = 0; i < draws; ++i) {
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      // Gamma weights of shape 1, and 1 / 2 for the prior; dividing by their sum is not necessary.
      weights[k] = k == prior ? std::pow(normal(1, random)[0], 2) / 2 : exponential(random);
      sums[k + 1] = sums[k] + weights[k];
    }
    double left = 0;
    double right = 0;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      left += weights[k] * sums[below[k]];
      right += weights[k] * (sums.back() - sums[not_above[k]]);
    }
    const double within = sums.back() * sums.back() - left - right;
    if (within >= std::max(left, right)) continue;
    ++(left > right ? negative : positive);
  }
  return {.negative = static_cast<double>(negative) / draws,
          .equivalent = static_cast<double>(draws - negative - positive) / draws,
          .positive = static_cast<double>(positive) / draws};
}

std::vector<double> holm(const std::vector<double>& p_values) {
  if (!std::all_of(p_values.begin(), p_values.end(), [](double p) { return p >= 0 && p <= 1; })) {
    throw std::invalid_argument("holm: p-values must be in [0, 1]");
  }
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return p_values[i] < p_values[k]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto left = static_cast<double>(order.size() - k);
    largest = std::max(largest, std::min(1.0, left * p_values[order[k]]));
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

}  // namespace ricochet
