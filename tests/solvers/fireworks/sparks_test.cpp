#include "solvers/fireworks/sparks.h"

#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::fireworks {
namespace {

constexpr int draws = 40000;

/// Expects the mean and the variance of what is drawn.
template <class Draw>
void expect_moments(Draw draw, double mean, double of_mean, double variance, double of_variance) {
  double sum = 0, squares = 0;
  for (int k = 0; k < draws; ++k) {
    const double x = draw();
    sum += x / draws;
    squares += x * x / draws;
  }
  EXPECT_NEAR(sum, mean, of_mean);
  EXPECT_NEAR(squares - sum * sum, variance, of_variance);
}

constexpr double epsilon = 2.2e-16;

TEST(ExplosionAmplitudes, GrowWithTheDistanceToTheBestWhichHasNextToNothing) {
  const Vector spread = explosion_amplitudes(Vector{{0, 1, 2, 3, 4}}, 40, epsilon);
  EXPECT_LT((spread - Vector{{0, 4, 8, 12, 16}}).cwiseAbs().maxCoeff(), 1e-12);
  const Vector tied_but_one = explosion_amplitudes(Vector{{7, 7, 7, 7, 8}}, 40, epsilon);
  EXPECT_LT((tied_but_one.head(4).array() - 40 * epsilon).abs().maxCoeff(), 1e-18);
  EXPECT_NEAR(tied_but_one[4], 40, 1e-12);
  EXPECT_EQ(explosion_amplitudes(Vector::Constant(5, 7), 40, epsilon), Vector::Constant(5, 40));
}

TEST(AmplitudeFloor, FallsAlongAQuarterOfAnEllipse) {
  const AmplitudeFloor floor{0.02, 0.001};
  for (const double t : {0.0, 0.1, 0.3, 0.7, 0.95, 1.0}) {
    // With 1 - t = cos(angle) the root is sin(angle).
    EXPECT_NEAR(floor.after(1000 * t, 1000), 0.02 - 0.019 * std::sin(std::acos(1 - t)), 1e-15);
  }
  EXPECT_DOUBLE_EQ(floor.after(0, 0), 0.02);
}

TEST(AmplitudeSteps, GrowOnSuccessAndDeclineElse) {
  EXPECT_DOUBLE_EQ(AmplitudeSteps().next(10, true), 12);
  EXPECT_DOUBLE_EQ(AmplitudeSteps().next(10, false), 9);
  for (const AmplitudeSteps& steps :
       {AmplitudeSteps{0.9, 0.9}, {1.2, 1.1}, {1.2, 0}, {quiet_nan, 0.9}}) {
    EXPECT_THROW(check(steps), std::invalid_argument) << steps.growth << ' ' << steps.decline;
  }
}

// What is just outside of symmetric ends is thrown near the origin.
TEST(Box, BringsBackByTheModuloOnlyWhatIsOutside) {
  const struct {
    double x, lower, upper, back;
  } cases[] = {{-3, -100, 100, -3},
               {-100, -100, 100, -100},
               {100, -100, 100, 100},
               {130, -100, 100, 30},
               {-130, -100, 100, 30},
               {18.5, 0, 18, 0.5},
               {-0.5, 0, 18, 0.5},
               {-7, 2, 10, 9},
               {5, 4, 4, 4},
               {100.001, -100, 100, 0.001},
               {-100.001, -100, 100, 0.001}};
  Random random;
  for (const auto& [x, lower, upper, back] : cases) {
    Vector point = Vector::Constant(1, x);
    Box(Vector::Constant(1, lower), Vector::Constant(1, upper))
        .bring_back(point, Mapping::modulo, random);
    EXPECT_NEAR(point[0], back, 1e-9) << x;
  }
}

TEST(Box, HoldsWhateverIsBroughtBack) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double scale = std::exp(40 * uniform(random) - 20);
    const Vector lower = scale * normal(3, random);
    Vector width = scale * normal(3, random).cwiseAbs();
    width[1] = 0;
    const Box box(lower, lower + width);
    ASSERT_THAT(box.free(), ElementsAre(0, 2)) << "coordinates with a width";
    const Vector x = lower + 3 * scale * normal(3, random);
    for (const Mapping mapping : {Mapping::modulo, Mapping::redraw}) {
      Vector back = x;
      box.bring_back(back, mapping, random);
      for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(back[k] >= box.lower()[k] && back[k] <= box.upper()[k]);
        const bool was_inside = x[k] >= box.lower()[k] && x[k] <= box.upper()[k];
        ASSERT_TRUE(back[k] == x[k] || !was_inside);
      }
    }
  }
}

TEST(Box, RedrawsNearACentre) {
  Random random(1);
  const Box box(Vector{{2, -1}}, Vector{{6, 1}});
  double least = 6, most = 2;
  for (int trial = 0; trial < 1000; ++trial) {
    Vector x{{7, 0.5}};
    box.bring_near(x, Vector{{5, 0}}, 0.5, random);
    EXPECT_EQ(x[1], 0.5);
    least = std::min(least, x[0]);
    most = std::max(most, x[0]);
  }
  EXPECT_TRUE(least >= 3 && least < 3.1) << least << ": half a width from the centre";
  EXPECT_TRUE(most <= 6 && most > 5.9) << most;
}

TEST(Box, RedrawsUniformly) {
  const Box box(Vector{{2, -1}}, Vector{{6, 1}});
  Random random(1);
  const auto redrawn = [&](Eigen::Index k) {
    return [&, k] {
      Vector x{{7, 0.5}};
      box.bring_back(x, Mapping::redraw, random);
      EXPECT_EQ(x[1], 0.5) << "it was inside";
      box.draw(x, random);
      return x[k];
    };
  };
  expect_moments(redrawn(0), 4, 0.05, 16.0 / 12, 0.05);
  expect_moments(redrawn(1), 0, 0.025, 4.0 / 12, 0.0125);
}

/// Of many draws of distinct coordinates: how often so many move, and how often each does.
void expect_shares(Moved moved, const std::vector<Eigen::Index>& all,
                   const std::map<std::size_t, double>& of_size, double of_coordinate) {
  Coordinates coordinates(all);
  Random random(1);
  std::map<std::size_t, double> sizes;
  std::map<Eigen::Index, double> times;
  for (int k = 0; k < draws; ++k) {
    const auto drawn = coordinates.draw(moved, random);
    EXPECT_EQ(std::set<Eigen::Index>(drawn.begin(), drawn.end()).size(), drawn.size());
    sizes[drawn.size()] += 1.0 / draws;
    for (const Eigen::Index i : drawn) times[i] += 1.0 / draws;
  }
  EXPECT_EQ(sizes.size(), of_size.size());
  EXPECT_EQ(times.size(), all.size());
  for (const auto& [size, share] : of_size) EXPECT_NEAR(sizes[size], share, 0.01);
  for (const Eigen::Index i : all) EXPECT_NEAR(times[i], of_coordinate, 0.01);
}

TEST(Coordinates, AreDrawnAsOftenAsTheirRuleSays) {
  const std::vector<Eigen::Index> three = {0, 2, 3};
  constexpr double third = 1.0 / 3;
  expect_shares(Moved::all, three, {{3, 1}}, 1);
  expect_shares(Moved::rounded, {4}, {{0, 0.5}, {1, 0.5}}, 0.5);  // maybe none
  expect_shares(Moved::rounded, three, {{0, third / 2}, {1, third}, {2, third}, {3, third / 2}},
                0.5);
  expect_shares(Moved::ceiled, {4}, {{1, 1}}, 1);  // at least one
  expect_shares(Moved::ceiled, three, {{1, third}, {2, third}, {3, third}}, 2 * third);
  expect_shares(Moved::coins, three, {{0, 0.125}, {1, 0.375}, {2, 0.375}, {3, 0.125}}, 0.5);
}

const SparkCountOptions as_printed = {.third_branch = ThirdBranch::as_printed};
const SparkCountOptions equal_shares = {.tied = TiedShare::equal};

TEST(SparkCounts, ShareTheSparksByQualityWithinLimits) {
  const Vector different{{0, 1, 2, 3, 4}}, best{{0, 10, 10, 10, 10}}, worst{{7, 7, 7, 7, 8}};
  const Vector tied = Vector::Constant(5, 7);
  // Excesses over the worst 4 3 2 1 0 of 10: shares 20, 15, 10, 5 and about 0 of 50.
  EXPECT_THAT(spark_counts(different, {}), ElementsAre(20, 15, 10, 5, 2));
  EXPECT_THAT(spark_counts(worst, {}), ElementsAre(13, 13, 13, 13, 2));
  EXPECT_THAT(spark_counts(worst, equal_shares), ElementsAre(13, 13, 13, 13, 2));
  EXPECT_THAT(spark_counts(best, {}), ElementsAre(40, 2, 2, 2, 2));
  EXPECT_THAT(spark_counts(tied, {}), ElementsAre(40, 40, 40, 40, 40));
  EXPECT_THAT(spark_counts(tied, equal_shares), ElementsAre(10, 10, 10, 10, 10));
  // As printed they are the fewest below the most.
  EXPECT_THAT(spark_counts(different, as_printed), ElementsAre(2, 2, 2, 2, 2));
  EXPECT_THAT(spark_counts(best, as_printed), ElementsAre(40, 2, 2, 2, 2));
  EXPECT_THAT(spark_counts(tied, as_printed), ElementsAre(40, 40, 40, 40, 40));
}

TEST(SparkCounts, StayWithinTheirLimitsAndFollowTheFitness) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const SparkCountOptions options = {
        .sparks = std::floor(20 + 200 * uniform(random)),
        .tied = uniform(random) < 0.5 ? TiedShare::most : TiedShare::equal};
    const Vector fitness = (3 * normal(5, random)).array().floor();
    const std::vector<int> counts = spark_counts(fitness, options);
    for (int i = 0; i < 5; ++i) {
      const int count = counts.at(static_cast<std::size_t>(i));
      ASSERT_GE(count, std::round(options.fewest * options.sparks));
      ASSERT_LE(count, std::round(options.most * options.sparks));
      for (int j = 0; j < 5; ++j) {
        ASSERT_TRUE(fitness[i] > fitness[j] || count >= counts[static_cast<std::size_t>(j)]);
      }
    }
    ASSERT_LE(std::accumulate(counts.begin(), counts.end(), 0), most_sparks(5, options));
  }
}

TEST(SparkCounts, AreRefusedWhereAFireworkMightHaveNone) {
  for (const SparkCountOptions& options : {SparkCountOptions{.sparks = 5},
                                           {.fewest = 0.9},
                                           {.most = 1},
                                           {.sparks = quiet_nan},
                                           {.epsilon = 0}}) {
    EXPECT_THROW(check(options), std::invalid_argument);
  }
  EXPECT_NO_THROW(check(SparkCountOptions{}));
}

class Spark : public testing::Test {
 protected:
  Random random_{1};
  const std::vector<Eigen::Index> moved_ = {0, 2};
  const Vector x_{{1, 2, 3}};
};

TEST_F(Spark, IsMovedByOneDrawInTheUnitOfEachCoordinate) {
  for (int k = 0; k < 100; ++k) {
    Vector x = x_;
    displace(x, moved_, 0.5, Vector{{1, 1, 4}}, Offsets::one, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_LE(std::abs(x[0] - 1), 0.5);
    EXPECT_NEAR(x[2] - 3, 4 * (x[0] - 1), 1e-14);
  }
}

TEST_F(Spark, IsMovedByDrawsOfTheirOwn) {
  double product = 0;
  const auto offset = [&] {
    Vector x = x_;
    displace(x, moved_, 0.5, Vector{{1, 1, 4}}, Offsets::each, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_LE(std::abs(x[2] - 3), 2);
    product += (x[0] - 1) * (x[2] - 3) / draws;
    return x[2] - 3;
  };
  expect_moments(offset, 0, 0.03, 4.0 / 3, 0.03);  // of U(-2, 2)
  EXPECT_NEAR(product, 0, 0.01);
}

TEST_F(Spark, IsMultipliedOrApproachesTheBestByOneNormalNumberOfVarianceOne) {
  const auto factor = [&] {
    Vector x = x_;
    multiply(x, moved_, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_NEAR(x[2], 3 * x[0], 1e-12);
    return x[0];
  };
  expect_moments(factor, 1, 0.03, 1, 0.05);
  const auto share_of_the_way = [&] {
    Vector x = x_;
    approach(x, moved_, Vector{{2, 7, 1}}, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_NEAR(x[2] - 3, -2 * (x[0] - 1), 1e-12);
    return x[0] - 1;
  };
  expect_moments(share_of_the_way, 0, 0.03, 1, 0.05);
  Vector best = x_;
  approach(best, moved_, x_, random_);
  EXPECT_EQ(best, x_) << "it approaches itself";
}

TEST_F(Spark, IsGuidedFromTheWorstToTheBest) {
  const Matrix sparks{{0, 0}, {1, 0}, {2, 5}, {3, 1}, {4, 7}};
  const std::vector<Eigen::Index> order = {4, 2, 0, 1, 3};
  const auto guided = [&](double share, double times = 1) {
    Vector x{{10, 20}};
    guide(x, sparks, order, share, times);
    return x;
  };
  // (4, 7), (2, 5) against (1, 0), (3, 1); at least one; the same on both sides
  EXPECT_LT((guided(0.4) - Vector{{11, 25.5}}).norm(), 1e-12);
  EXPECT_LT((guided(0.4, 2) - Vector{{12, 31}}).norm(), 1e-12);
  EXPECT_LT((guided(0.01) - Vector{{11, 26}}).norm(), 1e-12);
  EXPECT_LT((guided(1) - Vector{{10, 20}}).norm(), 1e-12);
  EXPECT_LT((mean_of_best(sparks, order, 0.4) - Vector{{3, 6}}).norm(), 1e-12);
}

}  // namespace
}  // namespace ricochet::fireworks
