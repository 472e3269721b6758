#include "solvers/acceptance.h"

#include <gtest/gtest.h>

#include "solvers/solvers.h"

namespace ricochet {
namespace {

Acceptance of(std::function<bool(const Problem&)> accepts) {
  Solver solver;
  solver.accepts = std::move(accepts);
  return acceptance_of(solver);
}

TEST(Acceptance, FindsOutWhatASolverTakes) {
  const Acceptance all = of([](const Problem&) { return true; });
  EXPECT_EQ(all.variables, "any number");
  EXPECT_EQ(all.constraints, "all");
  EXPECT_EQ(all.needs, "nothing");
  EXPECT_EQ(of([](const Problem& p) { return p.dimension() >= 2; }).variables, "2 or more");
  EXPECT_EQ(of([](const Problem& p) { return p.dimension() == 1; }).variables, "1");
  EXPECT_EQ(of([](const Problem& p) { return p.dimension() <= 8; }).variables, "up to 8");
  EXPECT_EQ(of([](const Problem& p) { return p.constraints == 0; }).constraints, "none");
  EXPECT_EQ(of([](const Problem& p) { return p.equalities == 0; }).constraints, "inequalities");
  EXPECT_EQ(of([](const Problem& p) { return p.constraints > p.equalities; }).constraints,
            "needs inequalities");
  const auto needs = [](auto has) {
    return of([has](const Problem& p) { return static_cast<bool>(has(p)); }).needs;
  };
  EXPECT_EQ(needs([](const Problem& p) { return p.differentiate; }), "gradients");
  EXPECT_EQ(needs([](const Problem& p) { return p.lagrangian_hessian; }), "Hessians");
  EXPECT_EQ(needs([](const Problem& p) { return p.residuals; }), "residuals");
  EXPECT_EQ(needs([](const Problem& p) { return p.smoothed && p.differentiate; }),
            "gradients and a width");
  EXPECT_THROW(of([](const Problem&) { return false; }), std::logic_error);
}

TEST(Acceptance, IsKnownOfEverySolver) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_NO_THROW(acceptance_of(solver)) << solver.name;
    if (solver.name == "bisection") {
      EXPECT_EQ(acceptance_of(solver).constraints, "needs inequalities");
      EXPECT_EQ(acceptance_of(solver).variables, "1");
    }
    if (solver.name == "nlopt-slsqp") {
      EXPECT_EQ(acceptance_of(solver).constraints, "all");
      EXPECT_EQ(acceptance_of(solver).needs, "gradients");
    }
  }
}

}  // namespace
}  // namespace ricochet
