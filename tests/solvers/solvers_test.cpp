#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "solvers/fireworks/fireworks.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

std::vector<std::string> accepting(const Problem& problem) {
  std::vector<std::string> names;
  for (const Solver& solver : all_solvers()) {
    if (solver.accepts(problem)) names.push_back(solver.name);
  }
  return names;
}

TEST(AllSolvers, AreThese) {
  std::vector<std::string> names;
  for (const Solver& solver : all_solvers()) names.push_back(solver.name);
  for (const MissingSolver& missing : missing_solvers()) {
    // As under the sanitizers, and where Debian's Python has no SciPy.
    if (missing.library == "TAO" || missing.library == "SciPy") names.push_back(missing.solver);
  }
  EXPECT_THAT(
      names,
      testing::UnorderedElementsAre(
          "fireworks", "fireworks-as-printed", "fireworks-authors", "fireworks-corrected", "efwa",
          "dynfwa", "bbfwa", "bbfwa-scaled", "bbfwa-tuned", "lotfwa", "lotfwa-scaled", "mgfwa",
          "fwassp", "random-search", "scan", "bisection", "golden-section", "mads", "mads-tuned",
          "scipy-slsqp", "scipy-l-bfgs-b", "scipy-dual-annealing", "scipy-differential-evolution",
          "ipopt", "ipopt-tuned", "ipopt-exact", "continuation-ipopt-tuned", "ceres-lbfgs",
          "ceres-trust-region", "pagmo-cmaes", "pagmo-cmaes-tuned", "pagmo-cmaes-ipop",
          "pagmo-cmaes-ipop-tuned", "pagmo-xnes", "pagmo-de", "pagmo-sade", "pagmo-de1220",
          "pagmo-gaco", "pagmo-compass-search", "pagmo-constrained-de", "dlib-global-search",
          "nlopt-direct", "nlopt-direct-l", "nlopt-crs2", "nlopt-isres", "nlopt-esch", "nlopt-ags",
          "nlopt-mlsl-bobyqa", "nlopt-mlsl-slsqp", "nlopt-mlsl-lbfgs", "nlopt-cobyla",
          "nlopt-cobyla-tuned", "nlopt-bobyqa", "nlopt-nelder-mead", "nlopt-sbplx", "nlopt-slsqp",
          "continuation-nlopt-slsqp", "nlopt-mma", "nlopt-ccsaq", "nlopt-lbfgs", "nlopt-var2",
          "nlopt-tnewton", "nlopt-auglag-bobyqa", "nlopt-auglag-sbplx", "nlopt-auglag-lbfgs",
          "nlopt-auglag-mma", "tao-blmvm", "tao-bqnls", "tao-bncg", "tao-pounders", "tao-brgn"));
}

TEST(AllSolvers, TakeEquationsWhereTheirAlgorithmDoes) {
  std::vector<std::string> names = accepting(arc());
  std::erase_if(names, [](const std::string& name) { return name.starts_with("scipy-"); });
  EXPECT_THAT(
      names, testing::UnorderedElementsAre(
                 "mads", "mads-tuned", "fireworks", "fireworks-as-printed", "fireworks-authors",
                 "fireworks-corrected", "efwa", "dynfwa", "bbfwa", "bbfwa-scaled", "bbfwa-tuned",
                 "lotfwa", "lotfwa-scaled", "mgfwa", "fwassp", "ipopt", "ipopt-tuned",
                 "ipopt-exact", "nlopt-isres", "nlopt-cobyla", "nlopt-cobyla-tuned", "nlopt-slsqp",
                 "nlopt-auglag-bobyqa", "nlopt-auglag-sbplx", "nlopt-auglag-lbfgs",
                 "nlopt-auglag-mma", "pagmo-gaco", "pagmo-compass-search", "pagmo-constrained-de"));
  Problem point_on_a_line = arc();
  point_on_a_line.lower = point_on_a_line.upper = point_on_a_line.start = Vector::Ones(1);
  point_on_a_line.lower[0] = 0;
  EXPECT_THAT(accepting(point_on_a_line), testing::Not(testing::Contains("scan")));
}

TEST(AllSolvers, NameTheLibraryBehindThemAndItsVersion) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_THAT(solver.version,
                testing::MatchesRegex(
                    "(ricochet|NLopt|Ipopt|Ceres|pagmo|dlib|PETSc|SciPy) [0-9]+\\.[0-9]+\\.[0-9]+"
                    "( \\(adapter [0-9]+\\))?"))
        << solver.name;
  }
}

TEST(SolverNamed, IsTheOneOrAnErrorThatSaysWhatMayBeMeant) {
  EXPECT_EQ(solver_named("nlopt-sbplx").name, "nlopt-sbplx");
  try {
    solver_named("nlopt-sbplex", "--solver");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--solver nlopt-sbplex: there is no such solver"));
    EXPECT_THAT(error.what(), testing::HasSubstr("nlopt-sbplx"));
  }
  for (const MissingSolver& missing : missing_solvers()) {
    EXPECT_THROW(solver_named(missing.solver), InputError);
  }
}

TEST(AllSolvers, HaveBothReadingsOfTheThirdBranch) {
  const auto end_of = [](const Solver& solver) {
    Problem problem = sphere(2, 3);
    Scorer scorer(problem);
    Evaluator evaluator(problem, {500}, &scorer);
    Random random;
    solver.solve(evaluator, problem.start, random);
    return scorer.best()->true_values.objective;
  };
  const double rounded = end_of(fireworks::fireworks("", fireworks::paper_options()));
  fireworks::FireworksOptions as_printed;
  as_printed.counts.third_branch = fireworks::ThirdBranch::as_printed;
  const double printed = end_of(fireworks::fireworks("", as_printed));
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
  EXPECT_THAT(accepting(problem), testing::IsEmpty());
}

}  // namespace
}  // namespace ricochet
