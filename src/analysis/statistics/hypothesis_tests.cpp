#include "src/analysis/statistics/hypothesis_tests.h"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "src/analysis/statistics/ranking.h"

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
