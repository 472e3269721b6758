#include "solvers/solvers.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

#include "solvers/fireworks/fireworks.h"
#include "tests/solvers/test_problems.h"

namespace ricochet {
namespace {

TEST(AllSolvers, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Solver& solver : all_solvers()) {
    EXPECT_TRUE(names.insert(solver.name).second) << solver.name;
  }
  EXPECT_THAT(names,
              testing::IsSupersetOf(
                  {"fireworks",   "fireworks-as-printed", "random-search",      "scan",
                   "ipopt",       "ceres-lbfgs",          "ceres-trust-region", "pagmo-cmaes",
                   "pagmo-sade",  "nlopt-direct-l",       "nlopt-crs2",         "nlopt-isres",
                   "nlopt-esch",  "nlopt-cobyla",         "nlopt-bobyqa",       "nlopt-nelder-mead",
                   "nlopt-sbplx", "nlopt-slsqp",          "nlopt-mma",          "nlopt-lbfgs"}));
}

TEST(AllSolvers, NameTheLibraryBehindThemAndItsVersion) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_THAT(solver.version, testing::MatchesRegex(
                                    "(ricochet|NLopt|Ipopt|Ceres|pagmo) [0-9]+\\.[0-9]+\\.[0-9]+"))
        << solver.name;
  }
}

TEST(AllSolvers, HaveBothReadingsOfTheThirdBranch) {
  const auto end_of = [](const Solver& solver) {
    Problem problem = sphere(2, 3);
    Evaluator evaluator(problem, {500});
    Random random;
    solver.solve(evaluator, problem.start, random);
    return evaluator.best()->truth.objective;
  };
  const double rounded = end_of(fireworks("", {.third_branch = ThirdBranch::rounded_share}));
  const double printed = end_of(fireworks("", {.third_branch = ThirdBranch::as_printed}));
  ASSERT_NE(rounded, printed);
  for (const Solver& solver : all_solvers()) {
    if (solver.name == "fireworks") {
      EXPECT_EQ(end_of(solver), rounded);
    }
    if (solver.name == "fireworks-as-printed") {
      EXPECT_EQ(end_of(solver), printed);
    }
  }
}

TEST(AllSolvers, AcceptNoBoxOfASinglePoint) {
  Problem problem = sphere(1, 3);
  problem.lower = problem.upper = problem.start;
  for (const Solver& solver : all_solvers()) EXPECT_FALSE(solver.accepts(problem)) << solver.name;
}

}  // namespace
}  // namespace ricochet
