// What every solver that takes derivatives promises where they are not finite.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "tests/support/numbers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// Which derivatives are not finite.
enum class Broken { gradient, jacobian, hessian };

/// Where they are not.
struct Region {
  const char* name;
  bool (*contains)(const Vector& x);
};

constexpr Region regions[] = {
    {"everywhere", [](const Vector&) { return true; }},
    {"at the start", [](const Vector& x) { return x.sum() > 2.9; }},
    {"away from the start", [](const Vector& x) { return x.sum() < 1; }},
};

/// disc() with residuals, whose values are finite everywhere and whose derivatives have one number
/// `bad` in a region.
Problem with_bad_derivatives(Broken broken, double bad, const Region& region) {
  Problem problem = disc();
  const auto hit = region.contains;
  problem.differentiate = [=, differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    if (hit(x) && broken == Broken::gradient) derivatives.gradient[1] = bad;
    if (hit(x) && broken == Broken::jacobian) derivatives.jacobian(0, 1) = bad;
    return derivatives;
  };
  problem.lagrangian_hessian = [=, hessian = problem.lagrangian_hessian](
                                   const Vector& x, double factor, const Vector& multipliers) {
    Matrix told = hessian(x, factor, multipliers);
    if (hit(x) && broken == Broken::hessian) told(1, 0) = told(0, 1) = bad;
    return told;
  };
  problem.residuals = [=](const Vector& x) {
    Residuals told = distances(x, -1);
    if (hit(x) && broken == Broken::jacobian) told.jacobian(0, 1) = bad;
    return told;
  };
  return with_idle_knob(problem);
}

/// The same without constraints; a gradient that is not finite in place of a Jacobian.
Problem without_constraints(Problem problem) {
  problem.constraints = 0;
  problem.evaluate = [](const Vector& x) { return Values{(x.array() + 1).square().sum(), {}}; };
  problem.differentiate = [evaluate = problem.evaluate,
                           differentiate = problem.differentiate](const Vector& x) {
    const Derivatives derivatives = differentiate(x);
    Vector gradient = 2 * (x.array() + 1);
    if (!derivatives.gradient.allFinite()) gradient[1] = derivatives.gradient[1];
    return Derivatives{evaluate(x), gradient, Matrix(0, x.size())};
  };
  problem.lagrangian_hessian = [hessian = problem.lagrangian_hessian](
                                   const Vector& x, double factor, const Vector&) -> Matrix {
    const Matrix told = hessian(x, factor, Vector::Zero(1));
    return told.allFinite() ? Matrix(2 * factor * Matrix::Identity(2, 2)) : told;
  };
  return with_idle_knob(problem);
}

class DerivativesContract : public testing::TestWithParam<Solver> {};

TEST_P(DerivativesContract, EndsEveryStartWhereADerivativeIsNotFinite) {
  const Solver& solver = GetParam();
  int runs = 0;
  for (const Broken broken : {Broken::gradient, Broken::jacobian, Broken::hessian}) {
    for (const double bad : {not_a_number, infinity, -infinity, 1e300}) {
      for (const Region& region : regions) {
        const Problem constrained = with_bad_derivatives(broken, bad, region);
        for (const Problem& problem : {constrained, without_constraints(constrained)}) {
          if (!solver.accepts(problem)) continue;
          SCOPED_TRACE(std::string(region.name) + ", derivative " + std::to_string(bad));
          const RunRecord record = run(problem, solver, {300}, 0);
          ++runs;
          EXPECT_EQ(record.failure, "");
          EXPECT_FALSE(record.terminations.empty());
          EXPECT_LE(record.ledger.charged, 300);
        }
      }
    }
  }
  EXPECT_GT(runs, 0);
}

// What it needs is nowhere finite: no start may end as if it had converged.
TEST_P(DerivativesContract, ClaimsNothingWithoutAFiniteDerivative) {
  const Solver& solver = GetParam();
  if (solver.name == "tao-pounders") GTEST_SKIP() << "it needs residuals, but no derivatives";
  const bool of_residuals = solver.capabilities.needs_residuals;
  for (const double bad : {not_a_number, infinity, -infinity}) {
    const Problem constrained =
        with_bad_derivatives(of_residuals ? Broken::jacobian : Broken::gradient, bad, regions[0]);
    for (const Problem& problem : {constrained, without_constraints(constrained)}) {
      if (!solver.accepts(problem)) continue;
      const RunRecord record = run(problem, solver, {300}, 0);
      for (const SolverTermination& exit : record.terminations) {
        // "failure" is Ceres's word for it; MLSL goes on to its next start until it is stopped.
        EXPECT_TRUE(exit.reason == "a number is not finite" || exit.reason == "failure" ||
                    exit.reason == "stopped by the evaluator")
            << exit.reason;
      }
    }
  }
}

std::vector<Solver> solvers_with_derivatives() {
  std::vector<Solver> solvers;
  for (Solver& solver : all_solvers()) {
    const bool takes_residuals = solver.capabilities.needs_residuals;
    if (takes_residuals || solver.capabilities.derivatives != Capabilities::Order::value) {
      solvers.push_back(std::move(solver));
    }
  }
  return solvers;
}

INSTANTIATE_TEST_SUITE_P(Of, DerivativesContract, testing::ValuesIn(solvers_with_derivatives()),
                         [](const auto& tested) { return test_name(tested.param.name); });

}  // namespace
}  // namespace ricochet
