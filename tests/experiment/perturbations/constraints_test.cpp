#include <gtest/gtest.h>

#include <cmath>

#include "src/experiment/perturbations.h"
#include "tests/core/hessian_check.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

TEST(BinaryConstraints, AnswerWhetherAConstraintHolds) {
  Random random(1);
  int held = 0, broken = 0;
  for (const Problem& problem : random_problems()) {
    const Perturbation perturbation = binary_constraints();
    EXPECT_EQ(perturbation.applies(problem), problem.constraints > 0);
    if (!perturbation.applies(problem)) continue;
    const Problem told = perturbation.perturbed(problem, 0);
    for (int k = 0; k < 20; ++k) {
      const Vector x = k == 0 ? *problem.best_point : uniform_point(problem, random);
      const Values own = problem.evaluate(x);
      const Values values = told.evaluate(x);
      EXPECT_EQ(values.objective, own.objective);
      for (Eigen::Index j = 0; j < problem.constraints; ++j) {
        const double value = own.constraints[j];
        const bool holds = (j < problem.equalities ? std::abs(value) : value) <= 1e-6;
        EXPECT_EQ(values.constraints[j], holds ? 0 : 1);
        ++(holds ? held : broken);
      }
      const bool feasible = true_values_at(problem, x).violation == 0;
      EXPECT_EQ(true_values_of(values, problem.equalities).violation == 0, feasible);
    }
  }
  EXPECT_GT(held, 50);
  EXPECT_GT(broken, 50);
}

TEST(BinaryConstraints, HaveNoSlopesAndNoCurvature) {
  Random random(1);
  for (const Problem& problem : random_problems()) {
    if (problem.constraints == 0) continue;
    const Problem told = binary_constraints().perturbed(problem, 0);
    const Vector& x = problem.start;
    const Derivatives d = told.differentiate(x);
    EXPECT_EQ(d.values.constraints, told.evaluate(x).constraints);
    EXPECT_EQ(d.gradient, problem.differentiate(x).gradient);
    EXPECT_EQ(d.jacobian, Matrix::Zero(problem.constraints, x.size()));
    EXPECT_EQ(told.residuals(x).jacobian, problem.residuals(x).jacobian);
    EXPECT_GT(expect_hessian_of_gradients(told, x, 0.7, normal(problem.constraints, random)), 0);
  }
}

TEST(BinaryConstraints, AllowEveryConstraintItsTolerance) {
  Problem problem = random_problems().front();
  problem.constraints = 6;
  problem.equalities = 4;
  problem.evaluate = [](const Vector&) {
    return Values{0, Vector{{9e-7, -9e-7, 1.1e-6, -1.1e-6, 9e-7, 1.1e-6}}};
  };
  const Problem told = binary_constraints().perturbed(problem, 0);
  EXPECT_EQ(told.evaluate(problem.start).constraints, (Vector{{0.0, 0.0, 1.0, 1.0, 0.0, 1.0}}));
}

TEST(BinaryConstraints, TakeWhatIsNoNumberForBroken) {
  Problem problem = random_problems().front();
  problem.constraints = 2;
  problem.equalities = 1;
  problem.evaluate = [](const Vector&) { return Values{0, Vector::Constant(2, std::nan(""))}; };
  const Problem told = binary_constraints().perturbed(problem, 0);
  EXPECT_EQ(told.evaluate(problem.start).constraints, Vector::Ones(2));
}

TEST(InfiniteWhereInfeasible, IsInfiniteWhereAnInequalityIsBrokenAndNowhereElse) {
  Random random(2);
  int inside = 0, outside = 0;
  for (const Problem& problem : random_problems()) {
    const Perturbation perturbation = infinite_where_infeasible();
    EXPECT_EQ(perturbation.applies(problem), problem.constraints > problem.equalities);
    if (!perturbation.applies(problem)) continue;
    const Problem told = perturbation.perturbed(problem, 0);
    const Vector multipliers = normal(problem.constraints, random);
    for (int k = 0; k < 20; ++k) {
      const Vector x = k == 0 ? *problem.best_point : uniform_point(problem, random);
      const Derivatives own = problem.differentiate(x);
      const Derivatives d = told.differentiate(x);
      const Residuals r = told.residuals(x);
      const Matrix hessian = told.lagrangian_hessian(x, 1, multipliers);
      EXPECT_EQ(told.evaluate(x).objective, d.values.objective);
      EXPECT_EQ(d.values.constraints, own.values.constraints);
      EXPECT_EQ(d.jacobian, own.jacobian);
      EXPECT_EQ(told.true_values(x).objective, own.values.objective);
      const Eigen::Index inequalities = problem.constraints - problem.equalities;
      if (own.values.constraints.tail(inequalities).maxCoeff() <= 0) {
        ++inside;
        EXPECT_EQ(d.values.objective, own.values.objective);
        EXPECT_EQ(d.gradient, own.gradient);
        EXPECT_EQ(r.values, problem.residuals(x).values);
        EXPECT_EQ(hessian, problem.lagrangian_hessian(x, 1, multipliers));
      } else {
        ++outside;
        EXPECT_EQ(d.values.objective, HUGE_VAL);
        EXPECT_TRUE(d.gradient.array().isNaN().all());
        EXPECT_EQ(r.values.squaredNorm(), HUGE_VAL);
        EXPECT_TRUE(r.jacobian.array().isNaN().all());
        EXPECT_TRUE(hessian.array().isNaN().all());
        EXPECT_EQ(told.lagrangian_hessian(x, 0, multipliers),
                  problem.lagrangian_hessian(x, 0, multipliers));
      }
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
}

}  // namespace
}  // namespace ricochet
