#include "solvers/nlopt.h"

#include <gmock/gmock.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "problems/classic/functions.h"
#include "ricochet/run.h"
#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

Solver named(const std::string& name) {
  const std::vector<Solver> solvers = nlopt_solvers();
  return *std::find_if(solvers.begin(), solvers.end(),
                       [&](const Solver& solver) { return solver.name == name; });
}

std::vector<std::string> accepting(const Problem& problem) {
  std::vector<std::string> names;
  for (const Solver& solver : nlopt_solvers()) {
    if (solver.accepts(problem)) names.push_back(solver.name);
  }
  return names;
}

TEST(Nlopt, AcceptsConstraintsWhereTheAlgorithmTakesThem) {
  EXPECT_THAT(accepting(disc()),
              testing::UnorderedElementsAre("nlopt-direct", "nlopt-direct-l", "nlopt-isres",
                                            "nlopt-ags", "nlopt-cobyla", "nlopt-cobyla-tuned",
                                            "nlopt-slsqp", "nlopt-mma", "nlopt-ccsaq",
                                            "nlopt-auglag-bobyqa", "nlopt-auglag-sbplx",
                                            "nlopt-auglag-lbfgs", "nlopt-auglag-mma"));
}

TEST(Nlopt, AcceptsProblemsWithoutDerivativesWhereTheAlgorithmNeedsNone) {
  Problem problem = sphere(2, 3);
  problem.differentiate = nullptr;
  EXPECT_THAT(accepting(problem),
              testing::UnorderedElementsAre(
                  "nlopt-direct", "nlopt-direct-l", "nlopt-crs2", "nlopt-isres", "nlopt-esch",
                  "nlopt-ags", "nlopt-mlsl-bobyqa", "nlopt-cobyla", "nlopt-cobyla-tuned",
                  "nlopt-bobyqa", "nlopt-nelder-mead", "nlopt-sbplx"));
}

TEST(Nlopt, KeepsWhatInterpolatesFromOneDimension) {
  for (const char* name : {"nlopt-bobyqa", "nlopt-mlsl-bobyqa"}) {
    EXPECT_FALSE(named(name).accepts(sphere(1, 3))) << name;
    EXPECT_TRUE(named(name).accepts(sphere(2, 3))) << name;
  }
  EXPECT_FALSE(named("nlopt-auglag-bobyqa").accepts(limited(7)));
  EXPECT_TRUE(named("nlopt-auglag-sbplx").accepts(limited(7)));
}

TEST(Nlopt, KeepsAgsFromMoreThanTenDimensions) {
  EXPECT_TRUE(named("nlopt-ags").accepts(sphere(10, 3)));
  EXPECT_FALSE(named("nlopt-ags").accepts(sphere(11, 3)));
}

class NloptLocal : public testing::TestWithParam<std::string> {};

TEST_P(NloptLocal, ConvergesToTheOptimumAndSaysSo) {
  const RunRecord record = run(sphere(2, 3), named(GetParam()), {500}, 0);
  EXPECT_THAT(record.terminations.front().reason, testing::AnyOf("xtol reached", "success"));
  EXPECT_GE(record.terminations.size(), 2U) << "it leaves the budget to another start";
  EXPECT_LT(record.trace.back().true_values.objective, 1e-10);
  ASSERT_TRUE(record.terminations.front().point);
  EXPECT_LT((record.terminations.front().point->array() - 3).abs().maxCoeff(), 1e-4);
}

TEST_P(NloptLocal, FindsAnOptimumInACorner) {
  const RunRecord record = run(sphere(2, 130), named(GetParam()), {500}, 0);
  EXPECT_NEAR(record.trace.back().true_values.objective, 2 * 30 * 30, 1e-3);
}

class NloptConstrained : public testing::TestWithParam<std::string> {};

TEST_P(NloptConstrained, EndsOnACurvedConstraintWithoutViolatingIt) {
  const RunRecord record = run(disc(), named(GetParam()), {500}, 0);
  EXPECT_EQ(record.terminations.front().reason, "xtol reached");
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -std::sqrt(2.0), 1e-6);
}

class NloptEquations : public testing::TestWithParam<std::string> {};

TEST_P(NloptEquations, EndsOnTheEquationWithinItsTolerance) {
  const RunRecord record = run(arc(), named(GetParam()), {500}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, *arc().best_known, 1e-5);
}

TEST_P(NloptLocal, DoesNotDependOnTheUnitsOfTheBoxInTheUnitCube) {
  const Solver solver = coordinates_of(GetParam()) == Coordinates::unit
                            ? named(GetParam())
                            : varied(GetParam(), GetParam(), {{"coordinates", "unit"}});
  const Problem metres = sphere(2, 3);
  Problem millimetres = metres;
  millimetres.lower *= 1024;  // a power of two keeps every digit
  millimetres.upper *= 1024;
  millimetres.start *= 1024;
  millimetres.evaluate = [metres](const Vector& x) { return metres.evaluate(x / 1024); };
  millimetres.differentiate = [metres](const Vector& x) {
    Derivatives d = metres.differentiate(x / 1024);
    d.gradient /= 1024;
    return d;
  };
  const RunRecord a = run(metres, solver, {40}, 0);
  const RunRecord b = run(millimetres, solver, {40}, 0);
  ASSERT_EQ(a.trace.size(), b.trace.size());
  EXPECT_EQ(a.trace.back().true_values.objective, b.trace.back().true_values.objective);
}

TEST_P(NloptLocal, EndsAStartAtANumberThatIsNotFinite) {
  const RunRecord record = run(half_a_number(), named(GetParam()), {300}, 0);
  EXPECT_EQ(record.terminations.front().reason, "a number is not finite");
  EXPECT_GE(record.terminations.size(), 2U);
}

// What reads memory that it has not set finds there what others have left.
TEST_P(NloptLocal, RepeatsItselfWhateverMemoryHolds) {
  const Problem problem = instance(classic::rastrigin(5), 2);
  std::set<std::vector<std::int64_t>> improved_after;
  for (int filling = 1; filling < 256; filling += 12) {
    mallopt(M_PERTURB, filling);  // of new memory
    std::vector<std::int64_t> evaluations;
    for (const Improvement& step : run(problem, named(GetParam()), {1500}, 2).trace) {
      evaluations.push_back(step.evaluations);
    }
    improved_after.insert(evaluations);
  }
  mallopt(M_PERTURB, 0);
  EXPECT_EQ(improved_after.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(All, NloptLocal,
                         testing::Values("nlopt-cobyla", "nlopt-bobyqa", "nlopt-nelder-mead",
                                         "nlopt-sbplx", "nlopt-slsqp", "nlopt-mma", "nlopt-ccsaq",
                                         "nlopt-lbfgs", "nlopt-var2", "nlopt-tnewton"),
                         [](const auto& tested) { return test_name(tested.param); });

INSTANTIATE_TEST_SUITE_P(All, NloptConstrained,
                         testing::Values("nlopt-cobyla", "nlopt-slsqp", "nlopt-mma", "nlopt-ccsaq"),
                         [](const auto& tested) { return test_name(tested.param); });

INSTANTIATE_TEST_SUITE_P(All, NloptEquations, testing::Values("nlopt-cobyla", "nlopt-slsqp"),
                         [](const auto& tested) { return test_name(tested.param); });

/// These approach the constraints from outside, by one local search after the other.
class NloptAugmentedLagrangian : public testing::TestWithParam<std::string> {};

TEST_P(NloptAugmentedLagrangian, ApproachesACurvedConstraint) {
  const RunRecord record = run(disc(), named(GetParam()), {5000}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -std::sqrt(2.0), 1e-6);
}

TEST_P(NloptAugmentedLagrangian, ApproachesAnEquation) {
  const RunRecord record = run(arc(), named(GetParam()), {5000}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, *arc().best_known, 1e-5);
}

TEST_P(NloptAugmentedLagrangian, IsOfUseForConstraintsOnly) {
  EXPECT_FALSE(named(GetParam()).accepts(sphere(2, 3)));
  EXPECT_TRUE(named(GetParam()).accepts(arc()));
}

INSTANTIATE_TEST_SUITE_P(All, NloptAugmentedLagrangian,
                         testing::Values("nlopt-auglag-bobyqa", "nlopt-auglag-sbplx",
                                         "nlopt-auglag-lbfgs", "nlopt-auglag-mma"),
                         [](const auto& tested) { return test_name(tested.param); });

/// The evolution strategy comes near the equation, if not within its tolerance.
TEST(Nlopt, ComesNearAnEquationByIsres) {
  const RunRecord record = run(arc(), named("nlopt-isres"), {5000}, 0);
  EXPECT_LT(record.trace.back().true_values.violation, 1e-3);
  EXPECT_NEAR(record.trace.back().true_values.objective, *arc().best_known, 0.5);
}

/// Rastrigin's function: a hollow at every point of whole numbers, the lowest, 0, at the origin.
Problem hollows() {
  Problem problem = box_problem("hollows", 2, -5.12, 4.12, 3.1, [](const Vector& x) {
    return (x.array().square() + 10 * (1 - (2 * M_PI * x.array()).cos())).sum();
  });
  differentiate_by(problem, [](const Vector& x) -> Vector {
    return 2 * x.array() + 20 * M_PI * (2 * M_PI * x.array()).sin();
  });
  return problem;
}

class NloptGlobal : public testing::TestWithParam<std::string> {};

TEST_P(NloptGlobal, GoesOnWhereANumberIsNotFinite) {
  const RunRecord record = run(half_a_number(), named(GetParam()), {300}, 0);
  EXPECT_EQ(record.ledger.charged, 300);
  ASSERT_EQ(record.terminations.size(), 1U);
  EXPECT_EQ(record.terminations.front().reason, "stopped by the evaluator");
}

TEST_P(NloptGlobal, FindsTheLowestOfManyHollowsOrTheNext) {
  const RunRecord record = run(hollows(), named(GetParam()), {4000}, 0);
  const bool slow = GetParam() == "nlopt-isres";
  EXPECT_LT(record.trace.back().true_values.objective, slow ? 2 : 0.05) << "the next four have 1";
}

INSTANTIATE_TEST_SUITE_P(All, NloptGlobal,
                         testing::Values("nlopt-direct", "nlopt-direct-l", "nlopt-crs2",
                                         "nlopt-isres", "nlopt-esch", "nlopt-ags",
                                         "nlopt-mlsl-bobyqa", "nlopt-mlsl-slsqp",
                                         "nlopt-mlsl-lbfgs"),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace ricochet
