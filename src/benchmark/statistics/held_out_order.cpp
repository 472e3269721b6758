#include "src/benchmark/statistics/held_out_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ricochet/random.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/rank_correlation.h"

namespace ricochet {
namespace {

constexpr std::size_t least_problems = 4;
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
  if (problems.size() < least_problems) return std::nullopt;
  Random random(seed);
  std::vector<std::size_t> order(problems.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t half = problems.size() / 2;
  std::vector<double> correlations;
  double stays = 0;
  for (int i = 0; i < halves; ++i) {
    shuffle(order, random);
    std::vector<RivalsAhead> a;
    std::vector<RivalsAhead> b;
    for (std::size_t k = 0; k < half; ++k) {
      a.push_back(problems[order[k]]);
      b.push_back(problems[order[half + k]]);
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
