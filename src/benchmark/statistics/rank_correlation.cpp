#include "src/benchmark/statistics/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/confidence.h"
#include "src/benchmark/statistics/ranks.h"

namespace ricochet {
namespace {

void check(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 2) {
    throw std::invalid_argument("rank correlation: samples of one length, at least 2, are needed");
  }
}

/// What Kendall's tau-b is computed from.
struct PairSums {
  double concordant_less_discordant = 0;
  double unlike_a = 0, unlike_b = 0;  ///< pairs that are not tied

  void add(const PairSums& other, double weight) {
    concordant_less_discordant += weight * other.concordant_less_discordant;
    unlike_a += weight * other.unlike_a;
    unlike_b += weight * other.unlike_b;
  }
  std::optional<double> correlation() const {
    if (unlike_a == 0 || unlike_b == 0) return std::nullopt;
    return concordant_less_discordant / std::sqrt(unlike_a * unlike_b);
  }
};

PairSums pair_of(const std::vector<double>& a, const std::vector<double>& b, std::size_t i,
                 std::size_t k) {
  const int sign_a = (a[i] > a[k]) - (a[i] < a[k]);
  const int sign_b = (b[i] > b[k]) - (b[i] < b[k]);
  return {static_cast<double>(sign_a * sign_b), static_cast<double>(sign_a * sign_a),
          static_cast<double>(sign_b * sign_b)};
}

}  // namespace

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  check(a, b);
  const std::vector<double> ranks_a = ranks_of(a);
  const std::vector<double> ranks_b = ranks_of(b);
  const double mean = (static_cast<double>(a.size()) + 1) / 2;
  double products = 0;
  double squares_a = 0;
  double squares_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    products += (ranks_a[i] - mean) * (ranks_b[i] - mean);
    squares_a += (ranks_a[i] - mean) * (ranks_a[i] - mean);
    squares_b += (ranks_b[i] - mean) * (ranks_b[i] - mean);
  }
  if (squares_a == 0 || squares_b == 0) return std::nullopt;
  return products / std::sqrt(squares_a * squares_b);
}

std::optional<double> kendall_rank_correlation(const std::vector<double>& a,
                                               const std::vector<double>& b) {
  check(a, b);
  PairSums sums;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) sums.add(pair_of(a, b, i, k), 1);
  }
  return sums.correlation();
}

std::optional<Interval> kendall_interval(const std::vector<double>& a, const std::vector<double>& b,
                                         const std::vector<std::string>& clusters,
                                         std::uint64_t seed, double confidence, int resamples) {
  check_confidence(confidence);
  check(a, b);
  if (clusters.size() != a.size()) {
    throw std::invalid_argument("kendall_interval: every pair needs a cluster");
  }
  std::map<std::string, std::size_t> numbers;
  std::vector<std::size_t> cluster_of;
  for (const std::string& name : clusters) {
    cluster_of.push_back(numbers.try_emplace(name, numbers.size()).first->second);
  }
  const std::size_t size = numbers.size();
  if (size < 5 || !kendall_rank_correlation(a, b)) return std::nullopt;
  // The sums of the pairs between two clusters, or within one: a sample only weighs them.
  std::vector<PairSums> between(size * size);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const auto [low, high] = std::minmax(cluster_of[i], cluster_of[k]);
      between[low * size + high].add(pair_of(a, b, i, k), 1);
    }
  }
  Random random(seed);
  std::vector<double> drawn;
  for (int sample = 0; sample < resamples; ++sample) {
    std::vector<double> times(size);
    for (std::size_t k = 0; k < size; ++k) {
      ++times[static_cast<std::size_t>(static_cast<double>(size) * uniform(random))];
    }
    PairSums sums;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = i; k < size; ++k) sums.add(between[i * size + k], times[i] * times[k]);
    }
    if (const auto correlation = sums.correlation()) drawn.push_back(*correlation);
  }
  if (drawn.empty()) return std::nullopt;
  return Interval{quantile(drawn, (1 - confidence) / 2), quantile(drawn, (1 + confidence) / 2)};
}

}  // namespace ricochet
