#include "solvers/fireworks/fireworks.h"

#include "tests/solvers/solve.h"

namespace ricochet::fireworks {
namespace {

/// What all members of the family promise beside what every solver does.
class Family : public OfSolver {};

TEST_P(Family, AsksForNothingOnceItIsRefused) {
  for (const std::int64_t budget : {1, 2, 5, 6, 17, 60, 210, 304, 311, 700}) {
    for (const Problem& problem : {sphere(3, 7), plateau(1), never_a_number(2), disc()}) {
      const RunRecord record = run(problem, solver(), {budget}, 1);
      EXPECT_EQ(record.ledger.charged, budget) << problem.name;
      EXPECT_EQ(record.ledger.refused, 1) << problem.name;
      EXPECT_EQ(record.terminations.size(), 1U) << problem.name;
    }
  }
}

TEST_P(Family, ComesNearAnEquationAndGoesOnWhereNothingIsANumberAtFirst) {
  EXPECT_LT(best_of(run(arc(), solver(), {20000}, 1)).violation, 1e-3);
  EXPECT_LT(end_of(half_a_number(), solver(), 3000), 100);
}

INSTANTIATE_TEST_SUITE_P(Of, Family, testing::ValuesIn(family()), by_solver);

std::vector<Vector> asked_on_plateau(const FireworksOptions& options, std::int64_t evaluations,
                                     Eigen::Index n = 3) {
  return asked_points(
      box_problem("wide plateau", n, -1000, 1000, 500, [](const Vector&) { return 7.0; }),
      fireworks("fireworks", options), evaluations);
}

/// A firework of the first five, and one of its sparks less the firework.
struct Flight {
  Vector from, offset;
};

/// Of the first sparks, so many of each of the first five fireworks.
std::vector<Flight> flights(const std::vector<Vector>& asked, std::size_t of_each = 40) {
  std::vector<Flight> all;
  for (std::size_t k = 5; k < 5 + 5 * of_each; ++k) {
    const Vector& from = asked.at((k - 5) / of_each);
    all.push_back({from, asked.at(k) - from});
  }
  return all;
}

TEST(Fireworks, SetsOff40SparksRoundEachFireworkOnAPlateauThenGaussianOnes) {
  const std::vector<Vector> asked = asked_on_plateau(paper_options(), 210);
  ASSERT_EQ(asked.size(), 210U);
  for (const auto& [from, offset] : flights(asked)) {
    EXPECT_LE(offset.cwiseAbs().maxCoeff(), 40);
    EXPECT_NE(offset[0], offset[1]) << "each coordinate has a draw of its own";
  }
  // A Gaussian spark is g times a firework, mapped. One coordinate that was not mapped tells g.
  const Box box(Vector::Constant(3, -1000), Vector::Constant(3, 1000));
  Random random;
  const auto multiple = [&](const Vector& spark, const Vector& x) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector scaled = x * (spark[i] / x[i]);
      box.bring_back(scaled, Mapping::modulo, random);
      if ((scaled - spark).norm() < 1e-9) return true;
    }
    return false;
  };
  for (std::size_t k = 205; k < 210; ++k) {
    EXPECT_TRUE(std::any_of(asked.begin(), asked.begin() + 5,
                            [&](const Vector& x) { return multiple(asked[k], x); }));
  }
}

TEST(Fireworks, OfTheAuthorsMoveSomeCoordinatesByOneDraw) {
  std::set<Eigen::Index> counts;
  for (const auto& [from, offset] : flights(asked_on_plateau(authors_options(), 205))) {
    const double draw = offset[0] != 0 ? offset[0] : offset[1] != 0 ? offset[1] : offset[2];
    counts.insert((offset.array() != 0).count());
    for (const double each : offset) EXPECT_TRUE(each == 0 || std::abs(each - draw) < 1e-9);
  }
  EXPECT_THAT(counts, ElementsAre(1, 2, 3));
}

TEST(Fireworks, InBoxWidthsFlyAsFarInEveryBox) {
  const FireworksOptions options{.amplitude = 0.05, .amplitude_unit = AmplitudeUnit::box_widths};
  double farthest = 0;
  for (const auto& [from, offset] : flights(asked_on_plateau(options, 205))) {
    for (Eigen::Index i = 0; i < 3; ++i) {  // those that are not mapped
      if (std::abs(from[i]) < 900) farthest = std::max(farthest, std::abs(offset[i]));
    }
  }
  EXPECT_GT(farthest, 90);
  EXPECT_LE(farthest, 100);
}

TEST(Fireworks, KeepsTheBestOfEveryGeneration) {
  // The best firework's amplitude is next to nothing, so each generation of at most some 60 points
  // asks again for the best point before it.
  const Problem problem = sphere(2, 3);
  const std::vector<Vector> asked = asked_points(problem, fireworks("fireworks", {}), 2000);
  Vector best = asked.front();
  std::size_t last_clone = 0;
  for (std::size_t k = 1; k < asked.size(); ++k) {
    if ((asked[k] - best).norm() < 1e-9) last_clone = k;
    ASSERT_LT(k - last_clone, 130U) << "two generations without it";
    if (problem.evaluate(asked[k]).objective < problem.evaluate(best).objective) best = asked[k];
  }
}

TEST(Fireworks, AsPublishedMissAShiftedOptimumThatTheEnhancedAndCorrectedFind) {
  const FireworksOptions as_printed{.counts = {.third_branch = ThirdBranch::as_printed}};
  for (const int number : {1, 2, 3}) {
    const auto end = [&](const FireworksOptions& options, double centre) {
      return end_of(sphere(30, centre), fireworks("fireworks", options), 10000, number);
    };
    for (const FireworksOptions& options : {paper_options(), as_printed, authors_options()}) {
      EXPECT_LT(end(options, 0), 1e-20) << "the origin";
      EXPECT_GT(end(options, 5), 1);
      EXPECT_GT(end(options, 30), 100);
    }
    for (const FireworksOptions& options : {enhanced_options(), corrected_options()}) {
      EXPECT_THAT(end(options, 0), AllOf(testing::Gt(1e-3), testing::Lt(300)));
      EXPECT_LT(end(options, 30), 300);
    }
  }
}

TEST(Fireworks, CorrectedSpendNoMoreThanTheirSparksOnAPlateauAndNoneTwice) {
  const std::vector<Vector> asked = asked_on_plateau(corrected_options(), 5000, 1);
  std::set<double> different;
  for (const Vector& x : asked) different.insert(x[0]);
  EXPECT_EQ(different.size(), asked.size());
  // 50 explosion sparks of the first five fireworks, 10 each, fly 0.2 box widths.
  for (const auto& [from, offset] : flights(asked, 10)) {
    const bool redrawn = std::abs(from[0]) > 600;
    EXPECT_TRUE(redrawn || std::abs(offset[0]) <= 400) << from;
  }
}

TEST(Fireworks, AsPublishedSpendHalfOfTheirSparksOnClonesWhereTheyRound) {
  int clones = 0;
  for (const auto& [from, offset] : flights(asked_on_plateau({.moved = Moved::rounded}, 205, 1))) {
    clones += offset[0] == 0;
  }
  EXPECT_NEAR(clones, 100, 30);
}

TEST(Fireworks, BeginInTheRegionTheyAreGiven) {
  const Solver solver = fireworks("fireworks", {.start_region = StartRegion{30, 50}});
  for (const Vector& x : asked_points(sphere(4, 0), solver, 5)) {
    EXPECT_TRUE(x.minCoeff() >= 30 && x.maxCoeff() <= 50) << x.transpose();
  }
}

TEST(Fireworks, RefuseOptionsThatMakeNoSense) {
  for (const FireworksOptions& options : {FireworksOptions{.fireworks = 0},
                                          {.amplitude = -1},
                                          {.amplitude = quiet_nan},
                                          {.counts = {.sparks = 5}},
                                          {.amplitude_floor = {0.1, 0.2}},
                                          {.gaussian_sparks = -1}}) {
    EXPECT_THROW(fireworks("refused", options), std::invalid_argument);
  }
}

}  // namespace
}  // namespace ricochet::fireworks
