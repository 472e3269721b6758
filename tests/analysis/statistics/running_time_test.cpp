#include "src/analysis/statistics/running_time.h"

#include "ricochet/random.h"
#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/profiles.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

TEST(ExpectedRunningTime, ChargesAFailedRunItsOwnLength) {
  // 20 + 100 + 60 evaluations for two successes.
  EXPECT_EQ(expected_running_time({{20, true}, {100, false}, {60, true}}), 90.0);
  EXPECT_FALSE(expected_running_time({{20, false}}));
  EXPECT_FALSE(expected_running_time({}));
}

std::vector<Effort> runs_of(int failures, int successes, double spent) {
  std::vector<Effort> runs(static_cast<std::size_t>(failures), {spent, false});
  runs.insert(runs.end(), static_cast<std::size_t>(successes), {spent, true});
  return runs;
}

TEST(ExpectedRunningTime, HasTheIntervalOfTheShareWhereAllRunsAreOfOneLength) {
  const Interval interval = expected_running_time_interval(runs_of(12, 3, 50));
  EXPECT_DOUBLE_EQ(interval.lower, 50 / wilson_interval(3, 15).upper);
  EXPECT_DOUBLE_EQ(interval.upper, 50 / wilson_interval(3, 15).lower);
}

TEST(ExpectedRunningTime, HasAnIntervalOfLengthAndShareWhereTheyAreUnrelated) {
  // Failures and successes of the lengths 40 and 60: their correlation is 0. Log-mean: 50, standard
  // error 10 sqrt(1 / 7), Student's t of 7 degrees of freedom 2.364624.
  const std::vector<Effort> runs = {{40, true}, {60, true}, {40, false}, {60, false},
                                    {40, true}, {60, true}, {40, false}, {60, false}};
  const double of_mean = 2.364624 * 10 / std::sqrt(7.0) / 50;
  const double of_share = std::log(wilson_interval(4, 8).upper / 0.5);
  const Interval interval = expected_running_time_interval(runs);
  EXPECT_NEAR(interval.lower, 100 * std::exp(-std::hypot(of_mean, of_share)), 1e-4);
}

TEST(ExpectedRunningTime, IsMoreCertainWhereSuccessesAreTheShorterTheMoreThereAre) {
  // Lengths and failures that go together vary the estimate more than those that are opposed.
  const Interval together = expected_running_time_interval(
      {{10, true}, {90, false}, {10, true}, {90, false}, {10, true}, {90, false}});
  const Interval opposed = expected_running_time_interval(
      {{90, true}, {10, false}, {90, true}, {10, false}, {90, true}, {10, false}});
  EXPECT_LT(together.lower, opposed.lower);
  EXPECT_GT(together.upper, opposed.upper);
}

TEST(ExpectedRunningTime, IsAtLeastSoMuchWhereNoRunSucceeded) {
  const Interval interval = expected_running_time_interval(runs_of(15, 0, 50));
  // The largest share at which 15 failures still have the chance 2.5 %.
  EXPECT_NEAR(std::pow(1 - 50 / interval.lower, 15), 0.025, 1e-12);
  EXPECT_EQ(interval.upper, infinity);
}

TEST(ExpectedRunningTime, IsUnknownAfterOneSuccess) {
  EXPECT_EQ(expected_running_time_interval({{50, true}}).lower, 0);
  EXPECT_EQ(expected_running_time_interval({{50, true}}).upper, infinity);
}

TEST(ExpectedRunningTime, ScalesWithItsUnit) {
  const std::vector<Effort> seconds = {{20, true}, {100, false}, {60, true}, {1, true}};
  std::vector<Effort> milliseconds = seconds;
  for (Effort& run : milliseconds) run.spent *= 1000;
  const Interval small = expected_running_time_interval(seconds);
  const Interval large = expected_running_time_interval(milliseconds);
  EXPECT_NEAR(large.lower, 1000 * small.lower, 1e-9 * large.lower);
  EXPECT_NEAR(large.upper, 1000 * small.upper, 1e-9 * large.upper);
  EXPECT_EQ(expected_running_time_interval(runs_of(1, 1, 0)).upper, 0);
}

TEST(ShiftedGeometricMean, IsWhatIsComputedByHand) {
  EXPECT_NEAR(shifted_geometric_mean({10, 100}), std::sqrt(20.0 * 110) - 10, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean({0.1, 0}), 1, 1e-12);  // both on the floor
  EXPECT_NEAR(shifted_geometric_mean({2, 8}, 0, 1), 4, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean({2, 8}, 1e9, 0), 5, 1e-5);  // the arithmetic mean at last
  EXPECT_TRUE(std::isinf(shifted_geometric_mean({2, infinity})));
}

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

TEST(ParetoFront, IsThatOfAllPairsCompared) {
  Random random(14);
  for (int i = 0; i < 100; ++i) {
    std::vector<CostAndError> points;
    for (int k = 0; k < 25; ++k) {
      points.push_back({std::floor(8 * uniform(random)), std::floor(8 * uniform(random))});
    }
    std::vector<std::size_t> front = pareto_front(points);
    EXPECT_TRUE(std::is_sorted(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
      return points[a].cost < points[b].cost;
    }));
    std::sort(front.begin(), front.end());
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CostAndError& own = points[k];
      const bool dominated =
          std::any_of(points.begin(), points.end(), [&](const CostAndError& other) {
            return other.cost <= own.cost && other.error <= own.error &&
                   (other.cost < own.cost || other.error < own.error);
          });
      if (!dominated) expected.push_back(k);
    }
    EXPECT_EQ(front, expected);
  }
}

TEST(VirtualBest, IsTheLeastOfEachProblem) {
  EXPECT_EQ(virtual_best({{3, 2}, {infinity, 7}, {infinity, infinity}}),
            (std::vector<double>{2, 7, infinity}));
  EXPECT_THROW(virtual_best({}), std::invalid_argument);
}

TEST(EmpiricalDistribution, IsTheShareOfPairsReached) {
  const std::vector<std::vector<double>> times = {{1, 5, infinity}, {5, 7, 9}};
  EXPECT_EQ(empirical_distribution(times, 0.5).mean, 0);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 1).mean, 1.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 5).mean, 3.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, infinity).mean, 5.0 / 6) << "never is never";
  EXPECT_DOUBLE_EQ(empirical_distribution({{1, 1, 1, 1}, {2}}, 1).mean, 0.5) << "problems alike";
}

TEST(EmpiricalDistribution, IsNoMoreCertainForMoreOfTheSamePairs) {
  const Interval once = empirical_distribution({{1}, {3}, {1}, {1}, {3}}, 2).interval;
  const Interval thrice =
      empirical_distribution({{1, 1, 1}, {3, 3, 3}, {1, 1, 1}, {1, 1, 1}, {3, 3, 3}}, 2).interval;
  EXPECT_EQ(once.lower, thrice.lower);
  EXPECT_EQ(once.upper, thrice.upper);
}

const Costs four_problems = {
    {1, 2, 4},
    {3, 3, infinity},
    {infinity, 5, 10},
    {infinity, infinity, infinity},
};

TEST(PerformanceProfile, HasTheRatiosAndSharesComputedByHand) {
  const Costs ratios = performance_ratios(four_problems);
  EXPECT_EQ(ratios,
            (Costs{{1, 2, 4}, {1, 1, infinity}, {infinity, 1, 2}, {infinity, infinity, infinity}}));
  EXPECT_EQ(performance_profile(ratios, 1, 1), 0.5);
  EXPECT_EQ(performance_profile(ratios, 1, 2), 0.75);
  EXPECT_EQ(performance_profile(ratios, 1, infinity), 0.75);
  EXPECT_EQ(performance_profile(ratios, 2, 1), 0);
  EXPECT_EQ(performance_profile(ratios, 2, 3.9), 0.25);
  EXPECT_EQ(performance_profile(ratios, 2, 4), 0.5);
}

TEST(PerformanceProfile, RisesFromWinsToSolvedProblems) {
  Random random(11);
  for (int i = 0; i < 30; ++i) {
    Costs drawn(20, std::vector<double>(4));
    for (auto& row : drawn) {
      for (double& cost : row)
        cost = uniform(random) < 0.3 ? infinity : 1 + std::floor(9 * uniform(random));
    }
    const Costs ratios = performance_ratios(drawn);
    for (std::size_t s = 0; s < 4; ++s) {
      double solved = 0;
      for (const auto& row : drawn) solved += std::isfinite(row[s]) ? 1 : 0;
      EXPECT_DOUBLE_EQ(performance_profile(ratios, s, 9), solved / 20);
      double before = 0;
      for (double ratio = 1; ratio < 10; ratio += 0.25) {
        const double share = performance_profile(ratios, s, ratio);
        EXPECT_GE(share, before);
        before = share;
      }
    }
  }
}

TEST(CostsOfSolvers, RefuseWhatDoesNotFit) {
  EXPECT_THROW(expected_running_time_interval({}), std::invalid_argument);
  EXPECT_THROW(expected_running_time_interval({{-1, true}}), std::invalid_argument);
  EXPECT_THROW(expected_running_time_interval({{infinity, false}}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({-1}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({std::nan("")}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({1}, 0, 0), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({1}, -1, 2), std::invalid_argument);
  EXPECT_THROW(seconds_to_target({1, infinity}, 1), std::invalid_argument);
  EXPECT_THROW(seconds_to_target({-1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(seconds_to_target(plain, -1), std::invalid_argument);
  EXPECT_THROW(cheapest_solver({}, 1), std::invalid_argument);
  EXPECT_THROW(break_even_simulation(plain, {1, -1}), std::invalid_argument);
  EXPECT_TRUE(pareto_front({}).empty());
  EXPECT_THROW(pareto_front({{1, std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(empirical_distribution({{}}, 1), std::invalid_argument);
  EXPECT_THROW(empirical_distribution({}, 1), std::invalid_argument);
  EXPECT_THROW(empirical_distribution({{std::nan("")}}, 1), std::invalid_argument);
  EXPECT_THROW(performance_ratios({}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{0, 2}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{std::nan(""), 2}}), std::invalid_argument);
  EXPECT_THROW(performance_profile({{1, 2}}, 2, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({}, 0, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({{-1}}, 0, 1), std::invalid_argument);
  EXPECT_EQ(check_costs({{1, 2, 3}, {4, 5, 6}}), 3U);
  EXPECT_THROW(check_costs({{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(check_costs({{1, -2}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
