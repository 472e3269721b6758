#include "src/analysis/statistics/ranking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet {

Ranking ranking_of(const std::vector<std::optional<Reached>>& reached) {
  const auto key = [&](std::size_t k) { return std::pair(reached[k]->value, reached[k]->cost); };
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    if (!reached[k]) continue;
    if (std::isnan(reached[k]->value) || std::isnan(reached[k]->cost)) {
      throw std::invalid_argument("ranking_of: a value is not a number");
    }
    order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return key(i) < key(k); });
  Ranking ranking;
  for (const std::size_t k : order) {
    if (ranking.empty() || key(ranking.back().front()) != key(k)) ranking.emplace_back();
    ranking.back().push_back(k);
  }
  return ranking;
}

std::vector<double> ranks_of(const std::vector<double>& sample) {
  if (std::any_of(sample.begin(), sample.end(), [](double x) { return std::isnan(x); })) {
    throw std::invalid_argument("ranks_of: a value is not a number");
  }
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return sample[i] < sample[k]; });
  std::vector<double> ranks(sample.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && sample[order[last]] == sample[order[first]]) ++last;
    const double shared = static_cast<double>(first + last + 1) / 2;
    for (; first < last; ++first) ranks[order[first]] = shared;
  }
  return ranks;
}

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

namespace {

std::size_t drawn_below(std::size_t size, Random& random) {
  return static_cast<std::size_t>(static_cast<double>(size) * uniform(random));
}

}  // namespace

std::vector<double> probabilities_of_being_first(const std::vector<RivalsAhead>& problems,
                                                 std::size_t entries, std::uint64_t seed,
                                                 int resamples) {
  const std::vector<std::vector<std::size_t>> clusters = clusters_of(problems);
  if (clusters.size() < 2 || resamples < 1) {
    throw std::invalid_argument(
        "probabilities_of_being_first: two clusters of problems and a sample are needed");
  }
  Random random(seed);
  std::vector<double> times(entries);
  for (int i = 0; i < resamples; ++i) {
    std::vector<double> sums(entries);
    std::vector<int> taken(entries);
    for (std::size_t draw = 0; draw < clusters.size(); ++draw) {
      for (const std::size_t q : clusters[drawn_below(clusters.size(), random)]) {
        const RivalsAhead& problem = problems[q];
        const std::size_t instances = problem.of_instance.size();
        for (std::size_t k = 0; k < instances; ++k) {
          const std::vector<double>& shares = problem.of_instance[drawn_below(instances, random)];
          for (std::size_t e = 0; e < shares.size(); ++e) {
            sums[problem.entries[e]] += shares[e] / static_cast<double>(instances);
          }
        }
        for (const std::size_t e : problem.entries) ++taken[e];
      }
    }
    std::vector<std::optional<double>> means(entries);
    for (std::size_t e = 0; e < entries; ++e) {
      if (taken[e] > 0) means[e] = sums[e] / taken[e];
    }
    const std::vector<std::size_t> first = first_of(means);
    for (const std::size_t e : first) times[e] += 1 / static_cast<double>(first.size());
  }
  for (double& share : times) share /= resamples;
  return times;
}

std::vector<std::vector<std::size_t>> clusters_of(const std::vector<RivalsAhead>& problems) {
  std::vector<std::string> names;
  for (const RivalsAhead& problem : problems) names.push_back(problem.cluster);
  return places_by_cluster(names);
}

RivalsAhead rivals_ahead(const std::vector<Ranking>& instances) {
  RivalsAhead all;
  for (const Ranking& ranking : instances) {
    std::map<std::size_t, double> ahead;
    double before = 0;
    for (const auto& tied : ranking) {
      const auto others = static_cast<double>(tied.size()) - 1;
      for (const std::size_t entry : tied) ahead[entry] = before + others / 2;
      before += others + 1;
    }
    std::vector<std::size_t> entries;
    std::vector<double> shares;
    for (const auto& [entry, number] : ahead) {
      entries.push_back(entry);
      shares.push_back(number / (before - 1));
    }
    if (!all.of_instance.empty() && entries != all.entries) {
      throw std::invalid_argument("rivals_ahead: the instances were ranked for different entries");
    }
    all.entries = std::move(entries);
    all.of_instance.push_back(std::move(shares));
  }
  return all.entries.size() < 2 ? RivalsAhead() : all;
}

std::vector<std::optional<double>> mean_rivals_ahead(const std::vector<RivalsAhead>& problems,
                                                     std::size_t entries) {
  std::vector<double> sums(entries);
  std::vector<int> taken(entries);
  for (const RivalsAhead& problem : problems) {
    for (std::size_t k = 0; k < problem.entries.size(); ++k) {
      double sum = 0;
      for (const auto& shares : problem.of_instance) sum += shares[k];
      sums[problem.entries[k]] += sum / static_cast<double>(problem.of_instance.size());
      ++taken[problem.entries[k]];
    }
  }
  std::vector<std::optional<double>> means(entries);
  for (std::size_t e = 0; e < entries; ++e) {
    // Rounded, so that equals stay equal in whatever order the problems come.
    if (taken[e] > 0) means[e] = std::round(1e12 * sums[e] / taken[e]) / 1e12;
  }
  return means;
}

std::vector<std::size_t> first_of(const std::vector<std::optional<double>>& means) {
  constexpr double rounding = 1e-12;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& mean : means) least = std::min(least, mean.value_or(least));
  std::vector<std::size_t> first;
  for (std::size_t e = 0; e < means.size(); ++e) {
    if (means[e] && *means[e] <= least + rounding) first.push_back(e);
  }
  return first;
}

namespace {

constexpr std::size_t least_clusters = 4;
constexpr std::size_t least_entries = 5;

void shuffle(std::vector<std::size_t>& order, Random& random) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    std::swap(order[i],
              order[static_cast<std::size_t>(static_cast<double>(i + 1) * uniform(random))]);
  }
}

/// The probability that one drawn from the firsts of a is one drawn from those of b.
double same_first(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  double both = 0;
  for (const std::size_t e : a) both += std::find(b.begin(), b.end(), e) == b.end() ? 0 : 1;
  return both / static_cast<double>(a.size() * b.size());
}

}  // namespace

std::optional<HeldOutOrder> held_out_order(const std::vector<RivalsAhead>& problems,
                                           std::size_t entries, std::uint64_t seed, int halves) {
  const std::vector<std::vector<std::size_t>> clusters = clusters_of(problems);
  if (clusters.size() < least_clusters) return std::nullopt;
  Random random(seed);
  std::vector<std::size_t> order(clusters.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t half = clusters.size() / 2;
  std::vector<double> correlations;
  double stays = 0;
  for (int i = 0; i < halves; ++i) {
    shuffle(order, random);
    std::vector<RivalsAhead> a;
    std::vector<RivalsAhead> b;
    for (std::size_t k = 0; k < half; ++k) {
      for (const std::size_t q : clusters[order[k]]) a.push_back(problems[q]);
      for (const std::size_t q : clusters[order[half + k]]) b.push_back(problems[q]);
    }
    auto means_a = mean_rivals_ahead(a, entries);
    auto means_b = mean_rivals_ahead(b, entries);
    std::vector<double> of_a;
    std::vector<double> of_b;
    for (std::size_t e = 0; e < entries; ++e) {
      if (means_a[e] && means_b[e]) {
        of_a.push_back(*means_a[e]);
        of_b.push_back(*means_b[e]);
      } else {
        means_a[e] = means_b[e] = std::nullopt;
      }
    }
    if (of_a.size() < least_entries) continue;
    const auto correlation = kendall_rank_correlation(of_a, of_b);
    if (!correlation) continue;
    correlations.push_back(*correlation);
    stays += same_first(first_of(means_a), first_of(means_b));
  }
  if (correlations.empty()) return std::nullopt;
  const auto size = static_cast<double>(correlations.size());
  return HeldOutOrder{std::accumulate(correlations.begin(), correlations.end(), 0.0) / size,
                      {quantile(correlations, 0.025), quantile(correlations, 0.975)},
                      stays / size};
}

}  // namespace ricochet
