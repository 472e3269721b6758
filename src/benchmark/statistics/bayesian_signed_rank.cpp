#include "src/benchmark/statistics/bayesian_signed_rank.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/benchmark/statistics/exponential.h"

namespace ricochet {
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

}  // namespace ricochet
