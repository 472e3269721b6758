#include "src/analysis/statistics/attainment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ricochet/random.h"

namespace ricochet {
namespace {

constexpr Levels levels = {3, 40};

/// Integer values, some of them beyond the levels.
History random_history(Random& random) {
  History history;
  double evaluations = 0;
  double value = 30 + std::floor(20 * uniform(random));
  while (value > 0) {
    evaluations += 1 + std::floor(8 * uniform(random));
    history.push_back({evaluations, value});
    value -= 1 + std::floor(6 * uniform(random));
  }
  return history;
}

TEST(Attainment, IsTheShareOfAllIntegerLevelsReached) {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const History history = random_history(random);
    std::vector<double> hitting_times;
    for (double level = levels.lower; level < levels.upper; ++level) {
      hitting_times.push_back(std::numeric_limits<double>::infinity());
      for (const auto& [evaluations, value] : history) {
        if (value <= level) hitting_times.back() = std::min(hitting_times.back(), evaluations);
      }
    }
    for (double t = 0; t < 90; ++t) {
      EXPECT_DOUBLE_EQ(attainment(history, levels, t),
                       empirical_distribution({hitting_times}, t).mean);
    }
  }
}

TEST(Attainment, HasTheAreaOfItsSumOverEvaluations) {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const History history = random_history(random);
    const double budget = 1 + std::floor(100 * uniform(random));
    double linear = 0;
    double logarithmic = 0;
    for (double t = 1; t <= budget; ++t) {
      linear += attainment(history, levels, t) / budget;
      logarithmic += attainment(history, levels, t) * std::log1p(1 / t) / std::log(budget + 1);
    }
    const auto area = [&](EvaluationAxis axis) {
      return area_over_convergence_curve(history, levels, budget, axis);
    };
    EXPECT_NEAR(area(EvaluationAxis::linear), linear, 1e-12);
    EXPECT_NEAR(area(EvaluationAxis::logarithmic), logarithmic, 1e-12);
  }
}

TEST(Attainment, IsAllForTheBestAtOnceAndNothingForNothing) {
  for (const EvaluationAxis axis : {EvaluationAxis::linear, EvaluationAxis::logarithmic}) {
    EXPECT_DOUBLE_EQ(area_over_convergence_curve({{1, 3}}, levels, 100, axis), 1);
    EXPECT_EQ(area_over_convergence_curve({}, levels, 100, axis), 0);
  }
}

TEST(Attainment, RefusesWhatDoesNotFit) {
  EXPECT_THROW(attainment({}, {3, 3}, 1), std::invalid_argument);
  EXPECT_THROW(attainment({{0, 5}}, levels, 1), std::invalid_argument);
  EXPECT_THROW(attainment({{1, 5}, {2, 5}}, levels, 1), std::invalid_argument);
  EXPECT_THROW(attainment({{2, 5}, {2, 4}}, levels, 1), std::invalid_argument);
  EXPECT_THROW(area_over_convergence_curve({}, levels, 0, EvaluationAxis::linear),
               std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
