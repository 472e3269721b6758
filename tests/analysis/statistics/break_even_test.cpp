#include "src/analysis/statistics/break_even.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "ricochet/random.h"

namespace ricochet {
namespace {

constexpr Expense plain = {100, 0, 1};      // many evaluations, no computing of its own
constexpr Expense model = {20, 0, 9};       // few, and much computing
constexpr Expense derivative = {0, 10, 1};  // gradients

TEST(BreakEven, IsWhatIsComputedByHand) {
  EXPECT_DOUBLE_EQ(seconds_to_target({20, 5, 9}, 0.5, 3), 9 + 0.5 * (20 + 15));
  EXPECT_DOUBLE_EQ(*break_even_simulation(plain, model, 1), 0.1);  // 1 + 100 c = 9 + 20 c
  EXPECT_FALSE(break_even_simulation(plain, derivative, 5));  // never dearer, always ahead
  EXPECT_FALSE(break_even_simulation({10, 0, 1}, {20, 0, 2}, 5));
  EXPECT_FALSE(break_even_simulation(plain, plain, 5));
}

TEST(BreakEven, HasTheCheapestOfAGrid) {
  const auto cheapest = cheapest_solvers({plain, model, derivative}, {0, 0.05, 1}, {1, 15});
  EXPECT_EQ(cheapest, (std::vector<std::vector<std::size_t>>{{0, 0}, {2, 0}, {2, 1}}));
}

TEST(BreakEven, IsWhereTheCheaperOfTwoChanges) {
  Random random(15);
  const auto drawn = [&] {
    return Expense{100 * uniform(random), 100 * uniform(random), 10 * uniform(random)};
  };
  int crossings = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Expense> pair = {drawn(), drawn()};
    const double price = 5 * uniform(random);
    const auto at = [&](double c, double p) { return cheapest_solvers(pair, {c}, {p})[0][0]; };
    if (const auto c = break_even_simulation(pair[0], pair[1], price)) {
      ++crossings;
      EXPECT_NEAR(seconds_to_target(pair[0], *c, price) / seconds_to_target(pair[1], *c, price), 1,
                  1e-9);
      EXPECT_NE(at(0.999 * *c, price), at(1.001 * *c, price));
    } else {
      EXPECT_EQ(at(1e-6, price), at(1e6, price));
    }
  }
  EXPECT_GT(crossings, 50);
}

TEST(BreakEven, RefusesWhatDoesNotFit) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(seconds_to_target({1, 1, infinity}, 1, 1), std::invalid_argument);
  EXPECT_THROW(seconds_to_target({-1, 1, 1}, 1, 1), std::invalid_argument);
  EXPECT_THROW(cheapest_solvers({}, {1}, {1}), std::invalid_argument);
  EXPECT_THROW(break_even_simulation(plain, model, -1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
