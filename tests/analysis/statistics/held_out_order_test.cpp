#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "ricochet/random.h"
#include "src/analysis/statistics/ranking.h"

namespace ricochet {
namespace {

constexpr std::size_t entries = 6;

/// Problems on which the entries come in an order that chance disturbs.
std::vector<RivalsAhead> noisy_problems(std::size_t number, double noise) {
  Random random(7);
  std::vector<RivalsAhead> problems;
  for (std::size_t q = 0; q < number; ++q) {
    std::vector<Ranking> instances;
    for (int i = 0; i < 3; ++i) {
      std::vector<std::optional<Reached>> reached;
      for (std::size_t e = 0; e < entries; ++e) {
        const double value = static_cast<double>(e) + noise * normal(1, random)[0];
        reached.push_back(Reached{std::round(value), 0});
      }
      instances.push_back(ranking_of(reached));
    }
    problems.push_back(rivals_ahead(instances));
  }
  return problems;
}

/// Kendall's tau-b by its definition.
double tau_b(const std::vector<double>& a, const std::vector<double>& b) {
  double concordant = 0, discordant = 0, tied_a = 0, tied_b = 0, pairs = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = i + 1; k < a.size(); ++k) {
      ++pairs;
      tied_a += a[i] == a[k] ? 1 : 0;
      tied_b += b[i] == b[k] ? 1 : 0;
      concordant += (a[i] - a[k]) * (b[i] - b[k]) > 0 ? 1 : 0;
      discordant += (a[i] - a[k]) * (b[i] - b[k]) < 0 ? 1 : 0;
    }
  }
  return (concordant - discordant) / std::sqrt((pairs - tied_a) * (pairs - tied_b));
}

std::vector<double> means_of(const std::vector<RivalsAhead>& problems,
                             const std::vector<std::size_t>& chosen) {
  std::vector<double> means(entries);
  for (const std::size_t q : chosen) {
    for (const auto& shares : problems[q].of_instance) {
      for (std::size_t e = 0; e < entries; ++e) means[e] += std::round(1e6 * shares[e]);
    }
  }
  return means;
}

double same_first(const std::vector<double>& a, const std::vector<double>& b) {
  double same = 0, firsts_a = 0, firsts_b = 0;
  const double least_a = *std::min_element(a.begin(), a.end());
  const double least_b = *std::min_element(b.begin(), b.end());
  for (std::size_t e = 0; e < a.size(); ++e) {
    firsts_a += a[e] == least_a ? 1 : 0;
    firsts_b += b[e] == least_b ? 1 : 0;
    same += a[e] == least_a && b[e] == least_b ? 1 : 0;
  }
  return same / firsts_a / firsts_b;
}

TEST(HeldOutOrder, IsTheMeanOverAllHalves) {
  for (const std::size_t number : {4U, 5U, 6U}) {
    const auto problems = noisy_problems(number, 2.5);
    const std::size_t half = number / 2;
    double sum = 0, stays = 0, splits = 0;
    // Each problem is in the first half (0), in the second (1) or left out (2).
    for (int code = 0; code < std::pow(3, number); ++code) {
      std::vector<std::vector<std::size_t>> parts(3);
      for (std::size_t q = 0, rest = static_cast<std::size_t>(code); q < number; ++q, rest /= 3) {
        parts[rest % 3].push_back(q);
      }
      if (parts[0].size() != half || parts[1].size() != half) continue;
      const auto a = means_of(problems, parts[0]);
      const auto b = means_of(problems, parts[1]);
      sum += tau_b(a, b);
      stays += same_first(a, b);
      ++splits;
    }
    const auto order = held_out_order(problems, entries, 1, 20000);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->correlation, sum / splits, 0.01) << number;
    EXPECT_NEAR(order->first_stays, stays / splits, 0.01) << number;
    EXPECT_LE(order->interval.lower, order->correlation);
    EXPECT_GE(order->interval.upper, order->correlation);
  }
}

TEST(HeldOutOrder, IsPerfectWhereAllProblemsAgree) {
  const auto order = held_out_order(noisy_problems(8, 0), entries, 1);
  EXPECT_NEAR(order->correlation, 1, 1e-12);
  EXPECT_EQ(order->first_stays, 1);
}

TEST(HeldOutOrder, HoldsClustersOutWhole) {
  // Both problems of a cluster agree, and clusters disagree: halves of problems would share them.
  std::vector<RivalsAhead> problems;
  for (const RivalsAhead& problem : noisy_problems(8, 3)) {
    for (int copy = 0; copy < 2; ++copy) {
      problems.push_back(problem);
      problems.back().cluster = std::to_string(problems.size() / 2 + problems.size() % 2);
    }
  }
  const auto whole = held_out_order(problems, entries, 1, 4000);
  EXPECT_NEAR(whole->correlation,
              held_out_order(noisy_problems(8, 3), entries, 1, 4000)->correlation, 0.02);
  for (RivalsAhead& problem : problems) problem.cluster.clear();
  EXPECT_GT(held_out_order(problems, entries, 1, 4000)->correlation, whole->correlation + 0.05);
}

TEST(HeldOutOrder, IsNothingForFewProblemsOrEntries) {
  EXPECT_FALSE(held_out_order(noisy_problems(3, 1), entries, 1));
  std::vector<RivalsAhead> two = noisy_problems(8, 1);
  for (std::size_t k = 0; k < two.size(); ++k) two[k].cluster = k < 4 ? "a" : "b";
  EXPECT_FALSE(held_out_order(two, entries, 1));
  const std::vector<RivalsAhead> four(6, rivals_ahead({{{0}, {1}, {2}, {3}}}));
  EXPECT_FALSE(held_out_order(four, 4, 1));
  const std::vector<RivalsAhead> tied(6, rivals_ahead({{{0, 1, 2, 3, 4, 5}}}));
  EXPECT_FALSE(held_out_order(tied, entries, 1));
}

}  // namespace
}  // namespace ricochet
