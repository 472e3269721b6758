#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

/// The problems of Hock and Schittkowski with their tolerances.
std::vector<Problem> hock_schittkowski_family() {
  const std::vector<Family> all = families();
  const auto hs =
      std::find_if(all.begin(), all.end(), [](const Family& f) { return f.name == "hs"; });
  return hs->problems;
}

std::vector<Problem> constrained_family() {
  std::vector<Problem> problems = hock_schittkowski_family();
  std::erase_if(problems, [](const Problem& p) { return p.constraints == 0; });
  return problems;
}

struct Worked {
  const char* name;
  double sum;  ///< of the multipliers' sizes
};

// Those that were beaten; worked by hand from the first-order conditions.
constexpr Worked worked[] = {{"hs-32", 2}, {"hs-39", 2}, {"hs-53", 440.0 / 43}};

TEST(HockSchittkowskiTolerance, GrowsByWhatTheConstraintToleranceIsWorth) {
  for (const Worked& each : worked) {
    const Problem problem = named(hock_schittkowski_family(), each.name);
    EXPECT_NEAR(problem.tolerance, 1e-6 * std::max(1.0, *problem.best_known) + 1e-6 * each.sum,
                1e-15)
        << each.name;
  }
  EXPECT_EQ(named(hock_schittkowski_family(), "hs-1").tolerance, 1e-6) << "without constraints";
  EXPECT_NEAR(named(hock_schittkowski_family(), "hs-13").tolerance, 0.0199 + 1e-6, 1e-12);
}

/// `problem` with all that counts as feasible: constraints moved by constraint_tolerance, an
/// equality as two inequalities, from the best point. What the solver returns is scored on
/// `problem`.
Problem with_all_that_is_feasible(const Problem& problem) {
  Problem relaxed = problem;
  const Eigen::Index equalities = problem.equalities;
  relaxed.start = *problem.best_point;
  relaxed.constraints = problem.constraints + equalities;
  relaxed.equalities = 0;
  const auto relax = [equalities](const Values& values) {
    Vector both(values.constraints.size() + equalities);
    both << values.constraints, -values.constraints.head(equalities);
    return Values{values.objective, both.array() - constraint_tolerance};
  };
  relaxed.evaluate = [relax, evaluate = problem.evaluate](const Vector& x) {
    return relax(evaluate(x));
  };
  relaxed.differentiate = [relax, equalities,
                           differentiate = problem.differentiate](const Vector& x) {
    const Derivatives d = differentiate(x);
    Matrix rows(d.jacobian.rows() + equalities, d.jacobian.cols());
    rows << d.jacobian, -d.jacobian.topRows(equalities);
    return Derivatives{relax(d.values), d.gradient, rows};
  };
  relaxed.true_values = [problem](const Vector& x) {
    return true_values_of(problem.evaluate(x), problem.equalities);
  };
  return relaxed;
}

// Solved must not be tighter than feasible: else a feasible point would beat the best value.
TEST(HockSchittkowskiTolerance, IsNotBeatenByAnyPointThatIsFeasible) {
  int beaten_by_more_than_the_first_part = 0;
  for (const Problem& problem : constrained_family()) {
    for (const Problem& shown : {problem, with_all_that_is_feasible(problem)}) {
      for (const char* name : {"nlopt-slsqp", "nlopt-cobyla", "ipopt"}) {
        const Solver solver = solver_named(name);
        if (!solver.accepts(shown)) continue;
        const RunRecord record = run(shown, solver, {50 * shown.dimension()}, 0);
        const Verdict verdict = judge(record, problem, problem.tolerance);
        if (!verdict.optimality_gap) continue;
        EXPECT_GE(*verdict.optimality_gap, -problem.tolerance) << problem.name << " by " << name;
        const double first_part = 1e-6 * std::max(1.0, std::abs(*problem.best_known));
        if (*verdict.optimality_gap < -first_part) ++beaten_by_more_than_the_first_part;
      }
    }
  }
  EXPECT_GT(beaten_by_more_than_the_first_part, 0) << "or the test shows nothing";
}

TEST(HockSchittkowskiTolerance, CountsWhatIsFeasibleAndBestAsSolved) {
  for (const Worked& each : worked) {
    const Problem problem = named(hock_schittkowski_family(), each.name);
    const RunRecord record =
        run(with_all_that_is_feasible(problem), solver_named("nlopt-cobyla"), {2000}, 0);
    const Verdict verdict = judge(record, problem, problem.tolerance);
    EXPECT_TRUE(verdict.solved) << each.name;
    EXPECT_LT(*verdict.optimality_gap, -1e-6 * std::max(1.0, *problem.best_known)) << each.name;
  }
}

}  // namespace
}  // namespace ricochet::classic
