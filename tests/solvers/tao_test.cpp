#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

Solver tao(const std::string& name) {
  for (Solver& solver : tao_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::out_of_range(name);
}

/// (x - centre)' A (x - centre) / 2 on [-1, 1]^n with A = 1 + tridiagonal(-1, 2, -1), whose
/// minimiser within the box, `best`, is given: the centre is so chosen that the slope there is
/// `pushes` < 0 where best is 1, > 0 where it is -1, and 0 elsewhere.
Problem bounded_quadratic(const Vector& best, const Vector& pushes) {
  const Eigen::Index n = best.size();
  Matrix a = 3 * Matrix::Identity(n, n);
  for (Eigen::Index i = 1; i < n; ++i) a(i, i - 1) = a(i - 1, i) = -1;
  const Vector centre = best - a.ldlt().solve(pushes);
  Problem problem = box_problem("bounded-quadratic", n, -1, 1, 0.3, [=](const Vector& x) {
    return 0.5 * (x - centre).dot(a * (x - centre));
  });
  differentiate_by(problem, [=](const Vector& x) -> Vector { return a * (x - centre); });
  const Matrix root = a.llt().matrixU();
  problem.residuals = [=](const Vector& x) { return Residuals{root * (x - centre), root}; };
  return problem;
}

TEST(Tao, FindsTheMinimumOfQuadraticsAtActiveBounds) {
  const Vector best{{1, 0.25, -1, -0.5, 0.125, 1}};
  const Vector pushes{{-2, 0, 1, 0, 0, -0.5}};
  const Problem problem = bounded_quadratic(best, pushes);
  for (const Solver& solver : tao_solvers()) {
    Evaluator evaluator(problem, {2000});
    Random random;
    const SolverTermination exit = solver.solve(evaluator, problem.start, random);
    ASSERT_TRUE(exit.point) << solver.name << ": " << exit.reason;
    EXPECT_LT((*exit.point - best).norm(), 1e-5) << solver.name << ": " << exit.reason;
    EXPECT_FALSE(evaluator.over()) << solver.name;
  }
}

/// Rosenbrock's function (1960) as residuals: 10 (y - x^2), 1 - x; optimum 0 at (1, 1).
Problem valley() {
  Problem problem = box_problem("valley", 2, -5, 5, 0, [](const Vector& x) {
    return 50 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2) / 2;
  });
  problem.start = Vector{{-1.2, 1}};
  problem.residuals = [](const Vector& x) {
    return Residuals{Vector{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}},
                     Matrix{{-20 * x[0], 10}, {-1, 0}}};
  };
  return problem;
}

TEST(Tao, SolvesLeastSquaresWithAndWithoutDerivatives) {
  for (const char* const name : {"tao-pounders", "tao-brgn"}) {
    const RunRecord record = run(valley(), tao(name), {400}, 0);
    EXPECT_EQ(record.failure, "");
    EXPECT_LT(record.trace.back().true_values.objective, 1e-9) << name;
  }
}

TEST(Tao, PoundersPaysForResidualsAlone) {
  const Problem problem = valley();
  Evaluator evaluator(problem, {100});
  Random random;
  tao("tao-pounders").solve(evaluator, problem.start, random);
  EXPECT_GT(evaluator.ledger().charged, 10);
  EXPECT_EQ(evaluator.ledger().charged, evaluator.ledger().derivatives);
}

TEST(Tao, LeavesSignalsAndEnvironmentAsTheyWere) {
  const auto handlers = [] {
    std::vector<void (*)(int)> all;
    for (int number = 1; number < 32; ++number) {
      struct sigaction now {};
      sigaction(number, nullptr, &now);
      all.push_back(now.sa_handler);
    }
    return all;
  };
  const auto before = handlers();
  run(sphere(2, 3), tao("tao-blmvm"), {50}, 0);
  EXPECT_EQ(handlers(), before);
  EXPECT_EQ(std::getenv("OMPI_MCA_ess"), nullptr);
}

/// In each of them it is initialised anew, if this test has a process of its own.
TEST(Tao, WorksInSeveralForkedProcessesAtOnceAndPrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::vector<pid_t> children;
  for (int k = 0; k < 4; ++k) {
    const pid_t child = fork();
    if (child == 0) {
      const RunRecord record = run(sphere(3, 3), tao("tao-bqnls"), {100}, 1);
      _exit(record.failure.empty() && record.trace.back().true_values.objective < 1e-12 ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Tao, TakesTurnsWithIpoptInOneProcess) {
  const Solver other = ipopt(Settings::own);
  const RunRecord alone = run(sphere(3, 3), other, {200}, 1);
  const RunRecord first = run(sphere(3, 3), tao("tao-blmvm"), {200}, 1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(run(sphere(3, 3), other, {200}, 1).terminations, alone.terminations);
    EXPECT_EQ(run(sphere(3, 3), tao("tao-blmvm"), {200}, 1).terminations, first.terminations);
  }
}

/// But for the 4 kB that POUNDERS itself loses where the budget ends among its first points.
TEST(Tao, KeepsNothingOfAThousandRuns) {
  for (const Solver& solver : tao_solvers()) {
    const auto use = [&](int times) {
      for (int k = 0; k < times; ++k) {
        const Problem problem = k % 2 == 0 ? sphere(5, 3) : half_a_number();
        Evaluator evaluator(problem, {k % 3 == 0 ? 4 : 60});
        Random random;
        solver.solve(evaluator, problem.start, random);
      }
    };
    use(100);
    const auto before = mallinfo2().uordblks;
    use(1000);
    const bool loses = solver.name == "tao-pounders";
    EXPECT_LT(mallinfo2().uordblks, before + (loses ? 1'000'000 : 20'000)) << solver.name;
  }
}

}  // namespace
}  // namespace ricochet
