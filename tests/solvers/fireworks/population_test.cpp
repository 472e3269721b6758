#include "solvers/fireworks/population.h"

#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet::fireworks {
namespace {

using Worths = std::vector<TrueValues>;

TEST(Population, KeepsPointsAndTheirWorthsInTheirOrder) {
  const Problem problem = limited(7);
  Evaluator evaluator(problem, {4});
  Population population(evaluator, 4);
  for (const double x : {5.0, 9.0, 7.0, 1.0}) EXPECT_TRUE(population.add(Vector::Constant(1, x)));
  EXPECT_FALSE(population.add(Vector::Constant(1, 2.0))) << "the budget is spent";
  EXPECT_EQ(population.size(), 4);
  EXPECT_EQ(population.worth(1).violation, 2);
  EXPECT_EQ(population.worths().size(), 4U);

  population.keep(std::vector<Eigen::Index>{3, 0, 3});
  EXPECT_EQ(population.points(), (Matrix{{1}, {5}, {1}}));
  EXPECT_THAT(population.worths(),
              ElementsAre(FieldsAre(-1, 0), FieldsAre(-5, 0), FieldsAre(-1, 0)));
  population.clear();
  EXPECT_EQ(population.size(), 0);
}

TEST(Fitness, IsTheObjectiveAndBehindTheWorstFeasiblePointTheViolation) {
  EXPECT_EQ(fitness_of(Worths{{3, 0}, {-2, 0}, {7, 0}}), (Vector{{3, -2, 7}}));
  EXPECT_EQ(fitness_of(Worths{{3, 0}, {-100, 0.5}, {7, 0}, {infinity, 2}}),
            (Vector{{3, 7.5, 7, 9}}));
  EXPECT_EQ(fitness_of(Worths{{-100, 0.5}, {-300, 2}}), (Vector{{0.5, 2}}));
}

TEST(Fitness, OfWhatIsNoNumberIsTheWorstThatIsOne) {
  for (const double bad : {quiet_nan, infinity, -infinity, 1e305}) {
    const TrueValues worth = worth_of({bad, {}}, 0);
    EXPECT_EQ(worth.objective, infinity);
    EXPECT_EQ(fitness_of(Worths{{3, 0}, worth, {7, 0}}), (Vector{{3, 7, 7}}));
    EXPECT_EQ(fitness_of(Worths{worth, worth}), (Vector{{0, 0}}));
    const double violation = worth_of({1, Vector::Constant(1, bad)}, 0).violation;
    EXPECT_EQ(violation, bad == -infinity ? 0 : infinity);
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
    Worths worths(6);
    for (TrueValues& worth : worths) {
      worth.objective = std::floor(6 * uniform(random)) - 3;
      worth.violation = std::max(0.0, std::floor(6 * uniform(random)) - 2);
      if (uniform(random) < 0.1) worth.objective = infinity;
    }
    const Vector fitness = fitness_of(worths);
    ASSERT_TRUE(fitness.allFinite());
    const auto usable = [](const TrueValues& worth) {
      return worth.violation > 0 || worth.objective < infinity;
    };
    for (Eigen::Index i = 0; i < 6; ++i) {
      for (Eigen::Index j = 0; j < 6; ++j) {
        const TrueValues &a = worths.data()[i], &b = worths.data()[j];
        const bool apart = a.violation != b.violation || a.violation == 0;
        const bool must_rank = better(a, b) && usable(a) && usable(b) && apart;
        ASSERT_TRUE(!must_rank || fitness[i] < fitness[j]);
      }
    }
  }
}

constexpr int selections = 40000;

TEST(Selection, TakesTheFirstOrAnyOfTheBest) {
  Random random(1);
  EXPECT_EQ(best_of(Worths{{5, 0}, {-9, 1}, {2, 0}, {2, 0}}, Ties::first, random), 2);
  EXPECT_EQ(best_of(Worths{{5, 2}, {-9, 3}, {7, 2}}, Ties::first, random), 0) << "least violated";
  const Worths worths = {{2, 0}, {5, 0}, {2, 0}, {2, 1}, {2, 0}};
  std::map<Eigen::Index, double> shares;
  for (int k = 0; k < selections; ++k) {
    shares[best_of(worths, Ties::any, random)] += 1.0 / selections;
  }
  const auto third = testing::DoubleNear(1.0 / 3, 0.01);
  EXPECT_THAT(shares, ElementsAre(testing::Pair(0, third), testing::Pair(2, third),
                                  testing::Pair(4, third)));
}

TEST(DistanceSums, AgreeWithTheirDefinitionButAreOneWhereAllPointsCoincideOrOneIsNoNumber) {
  EXPECT_EQ(distance_sums(Matrix::Constant(3, 1, 0.1)), Vector::Ones(3));
  EXPECT_EQ(distance_sums(Matrix::Constant(3, 2, 7)), Vector::Ones(3));
  EXPECT_EQ(distance_sums(Matrix{{-1e200, 0}, {1e200, 0}}), Vector::Ones(2));
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Index n = 1 + trial % 5;
    const auto count = static_cast<Eigen::Index>(2 + 40 * uniform(random));
    const Matrix points = normal(n * count, random).reshaped(count, n);
    const Vector sums = distance_sums(points);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double sum = (points.rowwise() - points.row(i)).rowwise().norm().sum();
      ASSERT_NEAR(sums[i], sum, 1e-12 * sum);
    }
  }
}

class Selected : public testing::Test {
 protected:
  const Matrix points_{{0}, {1}, {3}, {10}};  // whose sums of distances are 14, 12, 12, 26
  const Worths worths_ = {{5, 0}, {4, 0}, {3, 0}, {4, 0}};
  Random random_{1};

  /// Expects how often each is the one drawn beside the best, number 2.
  void expect_shares(const SelectionOptions& options, const Vector& expected) {
    Vector shares = Vector::Zero(4);
    for (int k = 0; k < selections; ++k) {
      const auto chosen = selected(points_, worths_, 2, options, random_);
      EXPECT_EQ(chosen.at(0), 2);
      shares[chosen.at(1)] += 1.0 / selections;
    }
    EXPECT_LT((shares - expected).cwiseAbs().maxCoeff(), 0.01) << shares.transpose();
  }
};

TEST_F(Selected, AreTheBestAndOthersByTheirDistancesOrUniform) {
  expect_shares({}, Vector{{14, 12, 12, 26}} / 64);
  expect_shares({.others = Others::uniform}, Vector::Constant(4, 0.25));
}

TEST_F(Selected, WithoutReplacementHaveTheBestOnlyOnce) {
  expect_shares({.replacement = false}, Vector{{14, 12, 0, 26}} / 52);
  for (int k = 0; k < 1000; ++k) {
    const auto all = selected(points_, worths_, 4, {.replacement = false}, random_);
    ASSERT_THAT(all, testing::UnorderedElementsAre(0, 1, 2, 3));
  }
}

TEST_F(Selected, NeverLoseTheBest) {
  for (int trial = 0; trial < 1000; ++trial) {
    Worths worths(12);
    for (TrueValues& worth : worths) {
      worth = {std::floor(5 * uniform(random_)), std::floor(2 * uniform(random_))};
    }
    const Matrix points = normal(24, random_).reshaped(12, 2);
    for (const Ties ties : {Ties::first, Ties::any}) {
      const auto chosen = selected(points, worths, 5, {.ties = ties}, random_);
      ASSERT_EQ(chosen.size(), 5U);
      const TrueValues& kept = worths[static_cast<std::size_t>(chosen.front())];
      for (const TrueValues& worth : worths) ASSERT_FALSE(better(worth, kept));
    }
  }
}

Matrix drawn_from(const SearchDistribution& distribution, Eigen::Index count, Random& random) {
  Matrix points(count, distribution.mean().size());
  for (Eigen::Index i = 0; i < count; ++i) points.row(i) = distribution.draw(random).transpose();
  return points;
}

TEST(SearchDistribution, DrawsWithItsMeanAndScale) {
  Random random(1);
  const SearchDistribution distribution(Vector{{3, -1}}, 0.5);
  const Matrix points = drawn_from(distribution, 20000, random);
  EXPECT_LT((points.colwise().mean().transpose() - distribution.mean()).norm(), 0.02);
  const Matrix apart = points.rowwise() - points.colwise().mean();
  EXPECT_LT((apart.transpose() * apart / 20000 - 0.25 * Matrix::Identity(2, 2)).norm(), 0.01);
  EXPECT_EQ(distribution.width(), 0.5);
}

TEST(SearchDistribution, HasItsSurfaceWhereATypicalPointLies) {
  const SearchDistribution distribution(Vector::Zero(2), 0.5);
  EXPECT_NEAR(distribution.distance(Vector{{0.5, 1}}), 1 + 4, 1e-12);
  // A standard normal vector of two coordinates is sqrt(pi / 2) long on average.
  EXPECT_NEAR(std::sqrt(distribution.expected()), std::sqrt(std::acos(-1) / 2), 2e-3);
  EXPECT_NEAR(distribution.radius_towards(Vector{{3, 4}}), 0.5 * std::sqrt(distribution.expected()),
              1e-12);
}

TEST(SearchDistribution, IsFittedToAPoint) {
  SearchDistribution distribution(Vector{{1, 2, 3}}, 0.5);
  const Matrix point{{1.2, 2, 6}};
  distribution.fit(point, 1);
  const Vector there = point.row(0).transpose();
  EXPECT_NEAR(distribution.distance(there), distribution.expected(), 1e-4);
  EXPECT_NEAR(distribution.radius_towards(there), (there - distribution.mean()).norm(), 1e-4);
  // Across, it stays as it was.
  EXPECT_NEAR(distribution.radius_towards(Vector{{1, 5, 3}}),
              0.5 * std::sqrt(distribution.expected()), 1e-6);

  SearchDistribution nearer(Vector{{0}}, 1);
  const double before = std::sqrt(nearer.expected());
  nearer.fit(Matrix::Constant(1, 1, 3 * before), 0.5);
  const double after = nearer.radius_towards(Vector{{1}});
  EXPECT_TRUE(after > 1.5 * before && after < 3 * before) << after / before;
  nearer.fit(Matrix::Zero(1, 1), 1);  // the mean itself has no direction
  EXPECT_NEAR(nearer.radius_towards(Vector{{1}}), after, 1e-6);
}

TEST(SearchDistribution, MovesToTheBetterHalfAndTurnsAlongIt) {
  Random random(1);
  SearchDistribution distribution(Vector::Zero(2), 1);
  for (int generation = 0; generation < 60; ++generation) {
    const Matrix sparks = drawn_from(distribution, 40, random);
    std::vector<Eigen::Index> order(40);
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto value = [&](Eigen::Index i) {
      const double along = sparks(i, 0) + sparks(i, 1) - 4, across = sparks(i, 0) - sparks(i, 1);
      return along * along + 1e4 * across * across;
    };
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index a, Eigen::Index b) { return value(a) < value(b); });
    distribution.adapt(sparks, order);
    if (generation == 15) {
      EXPECT_GT(distribution.distance(distribution.mean() + Vector{{1, -1}}),
                20 * distribution.distance(distribution.mean() + Vector{{1, 1}}));
    }
  }
  EXPECT_LT((distribution.mean() - Vector{{2, 2}}).norm(), 1e-2);
  EXPECT_LT(distribution.width(), 0.1);
}

TEST(SearchDistribution, StaysUsableWhereAllSparksAreOne) {
  SearchDistribution distribution(Vector::Zero(2), 1);
  const std::vector<Eigen::Index> order = {0, 1, 2, 3};
  for (int k = 0; k < 100; ++k) distribution.adapt(Matrix::Constant(4, 2, 0.5), order);
  EXPECT_GT(distribution.width(), 0);
  EXPECT_LT(distribution.width(), 1e3);
  EXPECT_TRUE(distribution.mean().allFinite());
}

}  // namespace
}  // namespace ricochet::fireworks
