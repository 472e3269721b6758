#include "src/analysis/statistics/hypothesis_tests.h"

#include "ricochet/random.h"
#include "src/analysis/statistics/ranking.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

std::vector<double> ranks_of_sizes(std::vector<double> differences) {
  for (double& x : differences) x = std::abs(x);
  return ranks_of(differences);
}

/// Sum of the ranks of the differences' sizes, with their signs.
double signed_rank_sum(const std::vector<double>& differences) {
  const std::vector<double> ranks = ranks_of_sizes(differences);
  double sum = 0;
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    sum += differences[k] > 0 ? ranks[k] : differences[k] < 0 ? -ranks[k] : 0;
  }
  return sum;
}

TEST(SignedRankTest, IsAsPublished) {
  // Hollander and Wolfe 1973, page 29: the depression scale at two visits; one-sided 0.01953 in R.
  EXPECT_DOUBLE_EQ(
      signed_rank_test({1.83 - 0.878, 0.50 - 0.647, 1.62 - 0.598, 2.48 - 2.05, 1.68 - 1.06,
                        1.88 - 1.29, 1.55 - 1.06, 3.06 - 3.14, 1.30 - 1.29}),
      20.0 / 512);
}

TEST(SignedRankTest, IsTheEnumerationOfAllSigns) {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> differences(1 + random() % 10);
    for (double& x : differences) x = std::floor(9 * uniform(random)) - 3;  // with ties and zeros
    std::replace(differences.begin(), differences.end(), 5.0, infinity);
    const double seen = std::abs(signed_rank_sum(differences));
    double as_far = 0;
    for (unsigned signs = 0; signs < 1U << differences.size(); ++signs) {
      std::vector<double> other = differences;
      for (std::size_t k = 0; k < other.size(); ++k) other[k] *= (signs >> k & 1U) != 0 ? -1 : 1;
      as_far += std::abs(signed_rank_sum(other)) >= seen ? 1 : 0;
    }
    EXPECT_NEAR(signed_rank_test(differences), as_far / std::exp2(differences.size()), 1e-12);
  }
}

TEST(SignedRankTest, IsNearTheShareOfRandomSignsWhereItIsNormal) {
  Random random(5);
  for (const double shift : {3.0, 3.2, 3.4}) {
    std::vector<double> differences;
    while (differences.size() < 300) {
      const double x = std::floor(7 * uniform(random) + shift) - 6;
      if (x != 0) differences.push_back(x);
    }
    const double seen = std::abs(signed_rank_sum(differences));
    const std::vector<double> ranks = ranks_of_sizes(differences);
    constexpr int draws = 4000;
    double as_far = 0;
    for (int i = 0; i < draws; ++i) {
      double sum = 0;
      for (const double rank : ranks) sum += (random() & 1U) != 0 ? rank : -rank;
      as_far += std::abs(sum) >= seen ? 1 : 0;
    }
    EXPECT_NEAR(signed_rank_test(differences), as_far / draws, 0.03);
  }
}

TEST(FisherExactTest, IsAsPublished) {
  // Fisher's lady tasting tea: three of four cups are right.
  EXPECT_NEAR(fisher_exact_test({3, 4}, {1, 4}), 34.0 / 70, 1e-12);
  // Fisher's convicted twins of criminals; 0.0005367 in R.
  EXPECT_NEAR(fisher_exact_test({2, 17}, {10, 13}), 0.0005367, 5e-8);
}

TEST(FisherExactTest, IsTheEnumerationOfAllTables) {
  for (int trials_a = 0; trials_a <= 5; ++trials_a) {
    for (int trials = trials_a; trials <= trials_a + 6; ++trials) {
      for (int successes = 0; successes <= trials; ++successes) {
        // By the successes of a: all choices of its trials among all, by the bits of a number.
        std::map<int, double> tables;
        double all = 0;
        for (unsigned choice = 0; choice < 1U << trials; ++choice) {
          if (std::popcount(choice) != trials_a) continue;
          ++tables[std::popcount(choice & ((1U << successes) - 1))];
          ++all;
        }
        for (const auto& [a, seen] : tables) {
          double as_rare = 0;
          for (const auto& [other, times] : tables) as_rare += times <= seen ? times : 0;
          EXPECT_NEAR(fisher_exact_test({a, trials_a}, {successes - a, trials - trials_a}),
                      as_rare / all, 1e-9)
              << a << " of " << trials_a << ", " << successes << " of " << trials;
        }
      }
    }
  }
}

/// Closed testing: a hypothesis falls only with every set of hypotheses that it is in, each of
/// which is tested by Bonferroni. That is what Holm's steps abbreviate.
double by_closed_testing(const std::vector<double>& p_values, std::size_t hypothesis) {
  double largest = 0;
  for (unsigned set = 1; set < 1U << p_values.size(); ++set) {
    if ((set >> hypothesis & 1U) == 0) continue;
    double least = 1, members = 0;
    for (std::size_t k = 0; k < p_values.size(); ++k) {
      if ((set >> k & 1U) == 0) continue;
      least = std::min(least, p_values[k]);
      ++members;
    }
    largest = std::max(largest, std::min(1.0, members * least));
  }
  return largest;
}

TEST(Holm, IsClosedTestingWithBonferroni) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> p_values(1 + random() % 7);
    for (double& p : p_values) p = std::round(20 * uniform(random)) / 100;  // with ties and zeros
    const std::vector<double> adjusted = holm(p_values);
    for (std::size_t k = 0; k < p_values.size(); ++k) {
      EXPECT_DOUBLE_EQ(adjusted[k], by_closed_testing(p_values, k));
    }
  }
}

TEST(HypothesisTests, RefuseWhatDoesNotFit) {
  EXPECT_EQ(signed_rank_test({}), 1);
  EXPECT_EQ(signed_rank_test({0, 0}), 1);
  EXPECT_THROW(signed_rank_test({1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(fisher_exact_test({3, 2}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(fisher_exact_test({1, 2}, {-1, 2}), std::invalid_argument);
  EXPECT_THAT(holm({}), IsEmpty());
  EXPECT_THROW(holm({0.5, 1.5}), std::invalid_argument);
  EXPECT_THROW(holm({std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
