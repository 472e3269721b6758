#include "src/analysis/statistics/running_time.h"

#include "ricochet/random.h"
#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/profiles.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::DoubleEq;

TEST(ExpectedRunningTime, ChargesAFailedRunItsOwnLength) {
  // 20 + 100 + 60 evaluations for two successes.
  EXPECT_EQ(expected_running_time({{20, true}, {100, false}, {60, true}}), 90.0);
  EXPECT_FALSE(expected_running_time({{20, false}}));
  EXPECT_FALSE(expected_running_time({}));
  EXPECT_THAT(expected_running_time_interval({{50, true}}), FieldsAre(0, infinity))
      << "the cost of a failure is unknown";
}

std::vector<Effort> runs_of(int failures, int successes, double spent) {
  std::vector<Effort> runs(static_cast<std::size_t>(failures), {spent, false});
  runs.insert(runs.end(), static_cast<std::size_t>(successes), {spent, true});
  return runs;
}

TEST(ExpectedRunningTime, HasTheIntervalOfTheShareWhereAllRunsAreOfOneLength) {
  const Interval share = wilson_interval(3, 15);
  EXPECT_THAT(expected_running_time_interval(runs_of(12, 3, 50)),
              FieldsAre(DoubleEq(50 / share.upper), DoubleEq(50 / share.lower)));
  // Where no run succeeded: the largest share at which 15 failures still have the chance 2.5 %.
  const Interval none = expected_running_time_interval(runs_of(15, 0, 50));
  EXPECT_NEAR(std::pow(1 - 50 / none.lower, 15), 0.025, 1e-12);
  EXPECT_EQ(none.upper, infinity);
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

TEST(BreakEven, IsWhatIsComputedByHand) {
  const Expense plain = {100, 1};  // many simulations, no computing of its own
  const Expense model = {20, 9};   // few, and much computing
  EXPECT_DOUBLE_EQ(seconds_to_target(model, 0.5), 19);
  EXPECT_DOUBLE_EQ(*break_even_simulation(plain, model), 0.1);  // 1 + 100 c = 9 + 20 c
  EXPECT_FALSE(break_even_simulation(plain, plain));
  EXPECT_EQ(cheapest_solver({plain, model}, 0.05), 0U);
  EXPECT_EQ(cheapest_solver({plain, plain}, 1), 0U) << "the first of equals";
  EXPECT_THAT(virtual_best({{3, 2}, {infinity, 7}, {infinity, infinity}}),
              ElementsAre(2, 7, infinity));
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
    std::vector<CostAndError> points(25);
    for (auto& [cost, error] : points) {
      cost = std::floor(8 * uniform(random));
      error = std::floor(8 * uniform(random));
    }
    std::vector<std::size_t> front = pareto_front(points), expected;
    EXPECT_TRUE(std::ranges::is_sorted(front, {}, [&](std::size_t k) { return points[k].cost; }));
    std::ranges::sort(front);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool dominated = std::ranges::any_of(points, [&](const CostAndError& other) {
        return other.cost <= points[k].cost && other.error <= points[k].error &&
               (other.cost < points[k].cost || other.error < points[k].error);
      });
      if (!dominated) expected.push_back(k);
    }
    EXPECT_EQ(front, expected);
  }
}

TEST(EmpiricalDistribution, IsTheShareOfPairsReached) {
  const std::vector<std::vector<double>> times = {{1, 5, infinity}, {5, 7, 9}};
  EXPECT_EQ(empirical_distribution(times, 0.5).mean, 0);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 1).mean, 1.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 5).mean, 3.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, infinity).mean, 5.0 / 6) << "never is never";
  EXPECT_DOUBLE_EQ(empirical_distribution({{1, 1, 1, 1}, {2}}, 1).mean, 0.5) << "problems alike";
  const Interval once = empirical_distribution({{1}, {3}, {1}}, 2).interval;
  EXPECT_THAT(empirical_distribution({{1, 1, 1}, {3, 3, 3}, {1, 1, 1}}, 2).interval,
              FieldsAre(once.lower, once.upper))
      << "no more certain for more of the same pairs";
}

TEST(PerformanceProfile, IsTheShareOfProblemsSolvedWithinARatioToTheLeastCost) {
  Random random(11);
  for (int i = 0; i < 30; ++i) {
    Costs costs(20, std::vector<double>(4));
    for (auto& row : costs) {
      for (double& cost : row)
        cost = uniform(random) < 0.5 ? infinity : std::ceil(9 * uniform(random));
    }
    const Costs ratios = performance_ratios(costs);
    for (std::size_t s = 0; s < 4; ++s) {
      for (const double ratio : {1.0, 1.5, 2.0, 3.5, 9.0, infinity}) {
        double within = 0;
        for (const auto& row : costs) {
          const double least = *std::ranges::min_element(row);
          within += std::isfinite(row[s]) && row[s] <= ratio * least ? 1 : 0;
        }
        EXPECT_DOUBLE_EQ(performance_profile(ratios, s, ratio), within / 20);
      }
    }
  }
  EXPECT_EQ(performance_ratios({{3, 6, infinity}, {infinity, infinity, infinity}}),
            (Costs{{1, 2, infinity}, {infinity, infinity, infinity}}));
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
  EXPECT_THROW(seconds_to_target({100, 1}, -1), std::invalid_argument);
  EXPECT_THROW(cheapest_solver({}, 1), std::invalid_argument);
  EXPECT_THROW(virtual_best({}), std::invalid_argument);
  EXPECT_THROW(break_even_simulation({100, 1}, {1, -1}), std::invalid_argument);
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
}

}  // namespace
}  // namespace ricochet
