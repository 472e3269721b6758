#include "src/benchmark/statistics/rank_sum_test.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "src/benchmark/statistics/ranks.h"

namespace ricochet {
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

}  // namespace ricochet
