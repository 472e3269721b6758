#include "solvers/pagmo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "ricochet/run.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// Rosenbrock's function in n variables, from the far end of its valley; optimum 0 at x_i = 1.
Problem rosenbrock(Eigen::Index n) {
  return box_problem("rosenbrock", n, -2, 2, -1.5, [](const Vector& x) {
    double sum = 0;
    for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
      sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
    }
    return sum;
  });
}

/// Rastrigin's function: a hollow at every point of whole numbers, the lowest, 0, at the origin.
Problem hollows(Eigen::Index n) {
  return box_problem("hollows", n, -5.12, 4.12, 3, [](const Vector& x) {
    return (x.array().square() + 10 * (1 - (2 * M_PI * x.array()).cos())).sum();
  });
}

/// What a single call of `solve` is charged where all points are worth the same.
std::int64_t asked_on_a_plateau(const Solver& solver, Eigen::Index n) {
  const Problem problem = plateau(n);
  Evaluator evaluator(problem, {1000});
  Random random;
  EXPECT_EQ(solver.solve(evaluator, problem.start, random).reason, "converged");
  return evaluator.ledger().charged;
}

double end_of(const Problem& problem, const Solver& solver, std::int64_t budget) {
  return run(problem, solver, {budget}, 1).trace.back().true_values.objective;
}

TEST(PagmoCmaes, AsksForFourAndThreeLogNPointsAGeneration) {
  EXPECT_EQ(asked_on_a_plateau(pagmo_cmaes(Settings::own), 1), 5) << "fewer pagmo refuses";
  EXPECT_EQ(asked_on_a_plateau(pagmo_cmaes(Settings::own), 2), 6);
  EXPECT_EQ(asked_on_a_plateau(pagmo_cmaes(Settings::own), 5), 8);
  EXPECT_EQ(asked_on_a_plateau(pagmo_cmaes(Settings::own), 20), 12);
}

TEST(PagmoXnes, AsksForAsManyAndLooksAtThemAfterAnotherGeneration) {
  EXPECT_EQ(asked_on_a_plateau(pagmo_xnes(), 1), 2 * 5);
  EXPECT_EQ(asked_on_a_plateau(pagmo_xnes(), 20), 2 * 12);
}

TEST(PagmoSade, AsksForTenNPointsAGenerationWithinLimits) {
  // It looks at what they are worth after a second generation.
  EXPECT_EQ(asked_on_a_plateau(pagmo_sade(), 1), 2 * 20);
  EXPECT_EQ(asked_on_a_plateau(pagmo_sade(), 5), 2 * 50);
  EXPECT_EQ(asked_on_a_plateau(pagmo_sade(), 20), 2 * 100);
}

TEST(PagmoCmaes, FollowsACurvedValley) {
  EXPECT_LT(end_of(rosenbrock(5), pagmo_cmaes(Settings::own), 5000), 1e-8);
}

TEST(PagmoSade, FollowsACurvedValley) {
  EXPECT_LT(end_of(rosenbrock(5), pagmo_sade(), 30000), 1e-3);
}

TEST(PagmoCmaes, FindsAShiftedOptimum) {
  EXPECT_LT(end_of(sphere(5, -20), pagmo_cmaes(Settings::own), 2500), 1e-8);
}

TEST(PagmoSade, FindsAShiftedOptimum) {
  EXPECT_LT(end_of(sphere(5, -20), pagmo_sade(), 8000), 1e-8);
}

TEST(PagmoSade, FindsTheLowestOfManyHollows) {
  EXPECT_LT(end_of(hollows(2), pagmo_sade(), 3000), 1e-8);
}

TEST(PagmoCmaesIpop, FindsTheLowestOfManyHollowsByGrowingPopulations) {
  // Populations that stay as they are begin some 60 times, in vain.
  EXPECT_LT(end_of(hollows(5), pagmo_cmaes_ipop(Settings::tuned), 40'000), 1e-8);
  EXPECT_GT(end_of(hollows(5), pagmo_cmaes(Settings::tuned), 40'000), 0.9);
}

Solver named(const std::string& name) {
  for (const Solver& solver : {pagmo_cmaes(Settings::own), pagmo_cmaes_ipop(Settings::own),
                               pagmo_xnes(), pagmo_de(), pagmo_sade(), pagmo_de1220(), pagmo_gaco(),
                               pagmo_compass_search(), pagmo_constrained_de()}) {
    if (solver.name == name) return solver;
  }
  throw std::invalid_argument(name);
}

class Pagmo : public testing::TestWithParam<std::string> {
 protected:
  Solver solver() const { return named(GetParam()); }
};

TEST_P(Pagmo, BeginsAtTheStart) {
  const Problem problem = sphere(3, 3);
  EXPECT_LT((run(problem, solver(), {1}, 0).trace.front().x - problem.start).norm(), 1e-12);
}

TEST_P(Pagmo, FindsAnOptimumInTheMiddle) {
  EXPECT_LT(end_of(sphere(2, 3), solver(), 4000), 1e-10);
}

TEST_P(Pagmo, FindsAnOptimumInACorner) {
  EXPECT_NEAR(end_of(sphere(2, 130), solver(), 3000), 2 * 30 * 30, 1e-3);
}

TEST_P(Pagmo, GoesRoundPointsWithoutNumbers) {
  EXPECT_LT(end_of(half_a_number(), solver(), 2000), 1e-6);
}

TEST_P(Pagmo, TakesEveryInfinityForTheWorst) {
  Problem problem = sphere(2, 3);
  problem.true_values = [evaluate = problem.evaluate](const Vector& x) {
    return true_values_of(evaluate(x));
  };
  problem.evaluate = [evaluate = problem.evaluate](const Vector& x) {
    if (x[0] > 50) return Values{-HUGE_VAL, {}};
    return x[0] < -50 ? Values{HUGE_VAL, {}} : evaluate(x);
  };
  EXPECT_LT(end_of(problem, solver(), 2000), 1e-6);
}

TEST_P(Pagmo, DoesNotDependOnTheUnitsOfBoxAndObjective) {
  const Problem metres = sphere(2, 3);
  Problem others = metres;
  const double micro = std::ldexp(1.0, -20);  // a power of two keeps every digit
  others.lower *= micro;
  others.upper *= micro;
  others.start *= micro;
  others.evaluate = [metres, micro](const Vector& x) {
    return Values{metres.evaluate(x / micro).objective * micro * micro, {}};
  };
  const RunRecord a = run(metres, solver(), {1500}, 0);
  const RunRecord b = run(others, solver(), {1500}, 0);
  ASSERT_EQ(a.trace.size(), b.trace.size());
  EXPECT_EQ(a.trace.back().x * micro, b.trace.back().x);
  EXPECT_EQ(a.terminations.front().reason, b.terminations.front().reason);
}

INSTANTIATE_TEST_SUITE_P(All, Pagmo,
                         testing::Values("pagmo-cmaes", "pagmo-cmaes-ipop", "pagmo-xnes",
                                         "pagmo-de", "pagmo-sade", "pagmo-de1220", "pagmo-gaco",
                                         "pagmo-compass-search"),
                         [](const auto& tested) { return test_name(tested.param); });

class PagmoThatConverges : public Pagmo {};

TEST_P(PagmoThatConverges, SaysSo) {
  const RunRecord record = run(sphere(2, 3), solver(), {4000}, 0);
  EXPECT_EQ(record.terminations.front().reason, "converged");
  EXPECT_GE(record.terminations.size(), 2U) << "it leaves the budget to another start";
}

INSTANTIATE_TEST_SUITE_P(All, PagmoThatConverges,
                         testing::Values("pagmo-cmaes", "pagmo-xnes", "pagmo-de", "pagmo-sade",
                                         "pagmo-de1220", "pagmo-compass-search"),
                         [](const auto& tested) { return test_name(tested.param); });

class PagmoConstrained : public Pagmo {};

TEST_P(PagmoConstrained, ComesNearACurvedConstraintWithoutViolatingIt) {
  const RunRecord record = run(disc(), solver(), {6000}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -std::sqrt(2.0), 0.02);
}

TEST_P(PagmoConstrained, ComesNearAnEquation) {
  const RunRecord record = run(arc(), solver(), {6000}, 0);
  EXPECT_LT(record.trace.back().true_values.violation, 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, PagmoConstrained,
                         testing::Values("pagmo-gaco", "pagmo-compass-search",
                                         "pagmo-constrained-de"),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(PagmoSolvers, TakeOnlyWhatTheyCanDo) {
  EXPECT_TRUE(pagmo_de().accepts(staircase())) << "one dimension, and no use of derivatives";
  EXPECT_FALSE(pagmo_de().accepts(disc()));
  EXPECT_TRUE(pagmo_gaco().accepts(staircase()));
  EXPECT_TRUE(pagmo_gaco().accepts(arc()));
  EXPECT_FALSE(pagmo_constrained_de().accepts(staircase()));
  EXPECT_TRUE(pagmo_constrained_de().accepts(arc()));
}

}  // namespace
}  // namespace ricochet
