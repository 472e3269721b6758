#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "src/analysis/statistics/ranking.h"

namespace ricochet {
namespace {

TEST(RankCorrelation, OfKendallIsWhatThePairsByHandGive) {
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {0.1, 0.2, 5, 6}), 1.0);
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {6, 5, 0.2, 0.1}), -1.0);
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 3, 2, 4}), (5.0 - 1) / 6);
  // Five pairs of six are untied in the first, all in the second.
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 3, 4}), 5 / std::sqrt(5.0 * 6));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 2, 2, 4}), 5 / std::sqrt(6 * 5.0));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 2, 4}), 1);
  EXPECT_FALSE(kendall_rank_correlation({1, 1, 1}, {1, 2, 3}));
}

/// Kendall's tau-b by its definition, or nothing.
std::optional<double> tau(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, unlike_a = 0, unlike_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = i + 1; k < a.size(); ++k) {
      const double product = (a[i] - a[k]) * (b[i] - b[k]);
      difference += product > 0 ? 1 : product < 0 ? -1 : 0;
      unlike_a += a[i] != a[k] ? 1 : 0;
      unlike_b += b[i] != b[k] ? 1 : 0;
    }
  }
  if (unlike_a * unlike_b == 0) return std::nullopt;
  return difference / std::sqrt(unlike_a * unlike_b);
}

TEST(RankCorrelation, OfKendallHasTheIntervalOfAllSamplesOfClusters) {
  const std::vector<double> a = {1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<double> b = {2, 1, 5, 4, 4, 8, 6, 7};
  const std::vector<std::string> clusters = {"p", "q", "q", "r", "s", "s", "t", "p"};
  EXPECT_EQ(kendall_rank_correlation(a, b), tau(a, b));
  std::vector<double> all;
  for (int code = 0; code < 3125; ++code) {  // five clusters drawn from five
    std::vector<double> drawn_a;
    std::vector<double> drawn_b;
    for (int draw = 0, rest = code; draw < 5; ++draw, rest /= 5) {
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (clusters[i][0] != 'p' + rest % 5) continue;
        drawn_a.push_back(a[i]);
        drawn_b.push_back(b[i]);
      }
    }
    if (const auto one = tau(drawn_a, drawn_b)) all.push_back(*one);
  }
  std::sort(all.begin(), all.end());
  const auto at = [&](double q) {
    return all[static_cast<std::size_t>(q * static_cast<double>(all.size()))];
  };
  const auto interval = kendall_interval(a, b, clusters, 1, 0.9, 20000);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->lower, at(0.05), 0.02);
  EXPECT_NEAR(interval->upper, at(0.95), 0.02);
  EXPECT_LT(interval->lower, interval->upper);
}

TEST(RankCorrelation, OfKendallHasAWiderIntervalIfEntriesAreAlike) {
  Random random(2);
  std::vector<double> a, b;
  std::vector<std::string> own, alike;
  for (int solver = 0; solver < 8; ++solver) {
    const Vector x = normal(2, random);
    for (int k = 0; k < 4; ++k) {
      a.push_back(x[0] + 0.01 * k);
      b.push_back(0.5 * x[0] + x[1] + 0.01 * k);
      own.push_back(std::to_string(own.size()));
      alike.push_back(std::to_string(solver));
    }
  }
  const auto narrow = kendall_interval(a, b, own, 1);
  const auto wide = kendall_interval(a, b, alike, 1);
  EXPECT_GT(wide->upper - wide->lower, 1.3 * (narrow->upper - narrow->lower));
}

TEST(RankCorrelation, OfKendallHasNoIntervalForFewClusters) {
  const std::vector<double> rising = {1, 2, 3, 4, 5};
  EXPECT_EQ(kendall_interval(rising, rising, {"a", "b", "c", "d", "e"}, 1)->lower, 1);
  EXPECT_FALSE(kendall_interval(rising, rising, {"a", "b", "c", "d", "a"}, 1));
  EXPECT_FALSE(kendall_interval({1, 1, 1, 1, 1}, rising, {"a", "b", "c", "d", "e"}, 1));
  EXPECT_THROW(kendall_interval(rising, rising, {"a"}, 1), std::invalid_argument);
}

TEST(RankCorrelation, RefusesSamplesThatDoNotFit) {
  EXPECT_THROW(kendall_rank_correlation({1, 2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(kendall_rank_correlation({1}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
