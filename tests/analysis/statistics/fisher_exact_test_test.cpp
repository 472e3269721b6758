#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "src/analysis/statistics/hypothesis_tests.h"

namespace ricochet {
namespace {

TEST(FisherExactTest, IsAsPublished) {
  // Fisher's lady tasting tea: three of four cups are right.
  EXPECT_NEAR(fisher_exact_test({3, 4}, {1, 4}), 34.0 / 70, 1e-12);
  // Fisher's convicted twins of criminals; 0.0005367 in R.
  EXPECT_NEAR(fisher_exact_test({2, 17}, {10, 13}), 0.0005367, 5e-8);
}

/// All choices of the trials of `a` among all, by the bits of a number.
double by_enumeration(Share a, Share b) {
  const int trials = a.trials + b.trials;
  const int successes = a.successes + b.successes;
  std::vector<int> tables(static_cast<std::size_t>(a.trials) + 1);
  for (unsigned choice = 0; choice < 1U << trials; ++choice) {
    if (std::popcount(choice) != a.trials) continue;
    ++tables[static_cast<std::size_t>(std::popcount(choice & ((1U << successes) - 1)))];
  }
  const int seen = tables[static_cast<std::size_t>(a.successes)];
  double as_rare = 0;
  double all = 0;
  for (const int table : tables) {
    all += table;
    as_rare += table <= seen ? table : 0;
  }
  return as_rare / all;
}

TEST(FisherExactTest, IsTheEnumerationOfAllTables) {
  for (int trials_a = 0; trials_a <= 5; ++trials_a) {
    for (int trials_b = 0; trials_b <= 6; ++trials_b) {
      for (int a = 0; a <= trials_a; ++a) {
        for (int b = 0; b <= trials_b; ++b) {
          EXPECT_NEAR(fisher_exact_test({a, trials_a}, {b, trials_b}),
                      by_enumeration({a, trials_a}, {b, trials_b}), 1e-9)
              << a << " of " << trials_a << ", " << b << " of " << trials_b;
        }
      }
    }
  }
}

TEST(FisherExactTest, RefusesCountsThatDoNotFit) {
  EXPECT_THROW(fisher_exact_test({3, 2}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(fisher_exact_test({1, 2}, {-1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
