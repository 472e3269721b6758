#include "problems/classic/classic.h"

#include "problems/classic/formula.h"
#include "problems/classic/functions.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

/// Test functions, constrained test problems, and least squares.
const std::vector<Problem>& published_problems() {
  static const std::vector<Problem> all = every_problem(families());
  return all;
}

/// The best point attains the best value, and lies in the box, which is finite, and in the
/// constraints. Families.HaveProblemsThatHoldTogether says the rest of all problems.
TEST(Classic, StatesWhatItIs) {
  for (const Problem& problem : published_problems()) {
    SCOPED_TRACE(problem.name);
    ASSERT_TRUE(problem.best_known && problem.best_point);
    const Vector& best = *problem.best_point;
    ASSERT_EQ(best.size(), problem.dimension());
    EXPECT_TRUE(problem.lower.allFinite() && problem.upper.allFinite());
    EXPECT_EQ(best.cwiseMax(problem.lower).cwiseMin(problem.upper), best);
    const Values values = problem.evaluate(best);
    EXPECT_NEAR(values.objective, *problem.best_known,
                1e-11 * std::abs(*problem.best_known) + 1e-20);
    EXPECT_EQ(values.constraints.size(), problem.constraints);
    EXPECT_EQ(true_values_at(problem, best).violation, 0);
    if (problem.equalities > 0) {
      const Matrix jacobian = problem.differentiate(best).jacobian.topRows(problem.equalities);
      const Vector terms = jacobian.cwiseAbs() * best.cwiseAbs();  // they cancel
      const Vector off = values.constraints.head(problem.equalities).cwiseAbs();
      EXPECT_TRUE((off.array() <= 1e-15 * terms.array().max(1000)).all()) << off.transpose();
    }
    if (problem.rotates) {
      EXPECT_TRUE((best.array() > problem.lower.array()).all());
      EXPECT_TRUE((best.array() < problem.upper.array()).all());
    }
  }
}

/// No random point of the problem, of 1000, and of its first instances, of 200 each, is feasible
/// and better than the best.
void expect_nothing_better(const Problem& problem) {
  SCOPED_TRACE(problem.name);
  Random random(seed_of(problem.name, "points", 0, 0));
  for (int number = 0; number <= 3; ++number) {
    const Problem moved = instance(problem, number);
    const int points = number == 0 ? 1000 : 200;
    for (int i = 0; i < points; ++i) {
      const TrueValues true_values = true_values_at(moved, uniform_point(moved, random));
      if (true_values.violation > 0) continue;
      ASSERT_GE(true_values.objective, *problem.best_known - 1e-9);
    }
  }
}

/// The first instances have the best value at their own best point, turned or not, but for a
/// rounding of each coordinate.
TEST(Classic, KeepsTheBestInInstances) {
  for (const Problem& problem : published_problems()) {
    SCOPED_TRACE(problem.name);
    double objective_off = 1e-9 * std::max(1.0, std::abs(*problem.best_known));
    double constraints_off = 1e-9;
    if (problem.differentiate) {
      const Derivatives d = problem.differentiate(*problem.best_point);
      const Vector rounding = 4e-15 * (problem.upper - problem.lower);
      objective_off += d.gradient.cwiseAbs().dot(rounding);
      if (problem.constraints > 0) constraints_off += (d.jacobian.cwiseAbs() * rounding).maxCoeff();
    }
    for (int number = 1; number <= 3; ++number) {
      const Problem moved = instance(problem, number);
      const TrueValues true_values = true_values_at(moved, *moved.best_point);
      EXPECT_NEAR(true_values.objective, *problem.best_known, objective_off);
      EXPECT_LE(true_values.violation, constraints_off);
    }
  }
}

TEST(Classic, HasTheFirstAndSecondDerivativesOfDifferences) {
  std::vector<Problem> problems = published_problems();
  for (Eigen::Index n = 1; n <= 9; ++n) problems.push_back(styblinski_tang(n));
  std::size_t curved = 0;
  for (const Problem& problem : problems) {
    SCOPED_TRACE(problem.name);
    ASSERT_EQ(!problem.differentiate, problem.name == "classic-step-5");
    ASSERT_EQ(!problem.lagrangian_hessian, !problem.differentiate);
    if (!problem.differentiate) continue;
    Random random(seed_of(problem.name, "derivatives", 0, 0));
    // LeastSquares.HasTheJacobianOfDifferences says it of the residuals of others.
    const int points = problem.name.starts_with("least-squares-") ? 0 : 3;
    for (int i = 0; i < points; ++i) {
      const Vector x = point_near_best(problem, random);
      const Derivatives d = problem.differentiate(x);
      EXPECT_EQ(all_of(d.values), all_of(problem.evaluate(x)));
      const auto objective = [&](const Vector& y) {
        return all_of(problem.evaluate(y)).head(1).eval();
      };
      const auto constraints = [&](const Vector& y) { return problem.evaluate(y).constraints; };
      expect_columns(problem, x, d.gradient.transpose(), objective, 1e-5);
      if (problem.constraints > 0) expect_columns(problem, x, d.jacobian, constraints, 1e-5);
    }
    // Near the best point, where every formula is defined.
    const Vector near = 0.98 * *problem.best_point + 0.02 * uniform_point(problem, random);
    const Vector multipliers =
        Vector::NullaryExpr(problem.constraints, [&] { return 2 * uniform(random) - 1; });
    const Matrix hessian = problem.lagrangian_hessian(near, 0.7, multipliers);
    if (!hessian.allFinite()) continue;
    EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm() + 1e-300);
    const auto slope = [&](const Vector& x) -> Vector {
      const Derivatives d = problem.differentiate(x);
      return 0.7 * d.gradient + d.jacobian.transpose() * multipliers;
    };
    expect_columns(problem, near, hessian, slope, 1e-5);
    ++curved;
  }
  EXPECT_GE(curved, 190U + 9);
}

TEST(Classic, HasNoRandomPointBelowTheBestAndNoneOutsideTheBoxWhereItTurns) {
  for (const Problem& problem : published_problems()) {
    expect_nothing_better(problem);
    if (problem.name.starts_with("classic-")) {
      EXPECT_EQ(problem.rotates, problem.name != "classic-schwefel-2.26-5") << problem.name;
    }
    if (!problem.rotates) continue;
    Problem wide = problem;
    wide.lower = 3 * problem.lower - 2 * problem.upper;
    wide.upper = 3 * problem.upper - 2 * problem.lower;
    expect_nothing_better(wide);
  }
}

Problem pathological(const std::string& name) {
  return named(pathological_family().problems, "pathological-" + name);
}

const Vector near{{0.1, 0.1}}, far{{0.9, 0.9}}, between{{0.35, 0.25}};

TEST(Pathological, HaveTheBestValueOfTheirTrueObjective) {
  for (const Problem& problem : pathological_family().problems) {
    SCOPED_TRACE(problem.name);
    EXPECT_TRUE(problem.hazardous);
    if (!problem.best_point) continue;
    EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, *problem.best_known);
    expect_nothing_better(problem);
  }
}

/// What scores a run, a target or a hash asks for everywhere.
TEST(Pathological, HaveTrueValuesEverywhere) {
  for (const char* name : {"throws", "hangs", "crashes", "no-number", "infinite"}) {
    EXPECT_DOUBLE_EQ(true_values_at(pathological(name), near).objective, 0.04) << name;
    EXPECT_DOUBLE_EQ(true_values_at(pathological(name), far).objective, 0.36) << name;
  }
}

TEST(Pathological, FailWhereTheySay) {
  EXPECT_TRUE(std::isnan(pathological("no-number").evaluate(far).objective));
  EXPECT_TRUE(pathological("no-number").differentiate(far).gradient.array().isNaN().all());
  EXPECT_EQ(pathological("infinite").evaluate(far).objective, HUGE_VAL);
  EXPECT_THROW(pathological("throws").evaluate(near), std::runtime_error);
  EXPECT_THROW(pathological("throws").residuals(near), std::runtime_error);
  EXPECT_DEATH(pathological("crashes").evaluate(near), "");
  EXPECT_EQ(pathological("plateau").evaluate(near).objective,
            pathological("plateau").evaluate(far).objective);
  EXPECT_GT(pathological("cliff").evaluate(Vector{{0.3 - 1e-9, 0}}).objective, 0.99);
  for (const Vector& x : {near, far, between}) {
    EXPECT_GT(true_values_at(pathological("infeasible"), x).violation, 1);
  }
}

TEST(Pathological, HaveTheirDerivativesElsewhere) {
  for (const Problem& problem : pathological_family().problems) {
    SCOPED_TRACE(problem.name);
    const Derivatives told = problem.differentiate(between);
    EXPECT_EQ(all_of(told.values), all_of(problem.evaluate(between)));
    expect_columns(
        problem, between, told.gradient.transpose(),
        [&](const Vector& x) { return all_of(problem.evaluate(x)).head(1).eval(); }, 1e-8);
  }
}

}  // namespace
}  // namespace ricochet::classic
