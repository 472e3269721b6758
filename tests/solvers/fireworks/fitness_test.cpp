#include <gtest/gtest.h>

#include <vector>

#include "solvers/fireworks/population.h"
#include "tests/support/numbers.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

TEST(Fitness, OfFeasiblePointsIsTheirObjective) {
  const std::vector<TrueValues> worths = {{3, 0}, {-2, 0}, {7, 0}};
  EXPECT_EQ(fitness_of(worths), (Vector{{3, -2, 7}}));
}

TEST(Fitness, OfInfeasiblePointsIsBehindTheWorstFeasibleOne) {
  const std::vector<TrueValues> worths = {{3, 0}, {-100, 0.5}, {7, 0}, {infinity, 2}};
  EXPECT_EQ(fitness_of(worths), (Vector{{3, 7.5, 7, 9}}));
}

TEST(Fitness, IsTheViolationWhereNothingIsFeasible) {
  const std::vector<TrueValues> worths = {{-100, 0.5}, {-300, 2}};
  EXPECT_EQ(fitness_of(worths), (Vector{{0.5, 2}}));
}

TEST(Fitness, OfWhatIsNoNumberIsTheWorstThatIsOne) {
  for (const double bad : {not_a_number, infinity, -infinity, 1e305}) {
    const TrueValues worth = worth_of({bad, {}}, 0);
    EXPECT_EQ(worth.objective, infinity);
    EXPECT_EQ(fitness_of(std::vector<TrueValues>{{3, 0}, worth, {7, 0}}), (Vector{{3, 7, 7}}));
    EXPECT_EQ(fitness_of(std::vector<TrueValues>{worth, worth}), (Vector{{0, 0}}));
    if (bad != -infinity) {
      EXPECT_EQ(worth_of({1, Vector::Constant(1, bad)}, 0).violation, infinity);
    }
  }
}

TEST(Fitness, TakesEquationsByTheirSize) {
  const Values values{1, Vector{{-3, 2, -7}}};
  EXPECT_EQ(worth_of(values, 1).violation, 3);
  EXPECT_EQ(worth_of(values, 0).violation, 2);
}

TEST(Fitness, RanksAsTheRulesOfFeasibilityDo) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<TrueValues> worths(6);
    for (TrueValues& worth : worths) {
      worth.objective = std::floor(6 * uniform(random)) - 3;
      worth.violation = std::max(0.0, std::floor(6 * uniform(random)) - 2);
      if (uniform(random) < 0.1) worth.objective = infinity;
    }
    const Vector fitness = fitness_of(worths);
    ASSERT_TRUE(fitness.allFinite());
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const bool usable = (worths[i].violation > 0 || worths[i].objective < infinity) &&
                            (worths[j].violation > 0 || worths[j].objective < infinity);
        const bool apart = worths[i].violation != worths[j].violation || worths[i].violation == 0;
        if (better(worths[i], worths[j]) && usable && apart) {
          ASSERT_LT(fitness[static_cast<Eigen::Index>(i)], fitness[static_cast<Eigen::Index>(j)]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace ricochet::fireworks
