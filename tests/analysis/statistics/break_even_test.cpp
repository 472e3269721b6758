#include "src/analysis/statistics/break_even.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "ricochet/random.h"

namespace ricochet {
namespace {

constexpr Expense plain = {100, 1};  // many simulations, no computing of its own
constexpr Expense model = {20, 9};   // few, and much computing

TEST(BreakEven, IsWhatIsComputedByHand) {
  EXPECT_DOUBLE_EQ(seconds_to_target({20, 9}, 0.5), 19);
  EXPECT_DOUBLE_EQ(*break_even_simulation(plain, model), 0.1);  // 1 + 100 c = 9 + 20 c
  EXPECT_FALSE(break_even_simulation({10, 1}, {20, 2}));        // always ahead
  EXPECT_FALSE(break_even_simulation(plain, plain));
  EXPECT_EQ(cheapest_solver({plain, model}, 0.05), 0U);
  EXPECT_EQ(cheapest_solver({plain, model}, 1), 1U);
  EXPECT_EQ(cheapest_solver({plain, plain}, 1), 0U) << "the first of equals";
}

TEST(BreakEven, IsWhereTheCheaperOfTwoChanges) {
  Random random(15);
  int crossings = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Expense> pair = {{100 * uniform(random), 10 * uniform(random)},
                                       {100 * uniform(random), 10 * uniform(random)}};
    if (const auto c = break_even_simulation(pair[0], pair[1])) {
      ++crossings;
      EXPECT_NEAR(seconds_to_target(pair[0], *c) / seconds_to_target(pair[1], *c), 1, 1e-9);
      EXPECT_NE(cheapest_solver(pair, 0.999 * *c), cheapest_solver(pair, 1.001 * *c));
    } else {
      EXPECT_EQ(cheapest_solver(pair, 1e-6), cheapest_solver(pair, 1e6));
    }
  }
  EXPECT_GT(crossings, 50);
}

TEST(BreakEven, RefusesWhatDoesNotFit) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(seconds_to_target({1, infinity}, 1), std::invalid_argument);
  EXPECT_THROW(seconds_to_target({-1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(seconds_to_target(plain, -1), std::invalid_argument);
  EXPECT_THROW(cheapest_solver({}, 1), std::invalid_argument);
  EXPECT_THROW(break_even_simulation(plain, {1, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
