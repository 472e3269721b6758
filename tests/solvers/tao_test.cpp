#include <malloc.h>

#include <Eigen/Cholesky>
#include <csignal>

#include "solvers/library_solvers.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

// (x - centre)' A (x - centre) / 2 on [-1, 1]^6 with A = 1 + tridiagonal(-1, 2, -1): the centre is
// so chosen that the slope at `best` is `pushes` < 0 where best is 1, > 0 where it is -1, and else
// 0.
TEST(Tao, FindsTheMinimumOfQuadraticsAtActiveBounds) {
  const Vector best{{1, 0.25, -1, -0.5, 0.125, 1}};
  const Vector pushes{{-2, 0, 1, 0, 0, -0.5}};
  Matrix a = 3 * Matrix::Identity(6, 6);
  for (Eigen::Index i = 1; i < 6; ++i) a(i, i - 1) = a(i - 1, i) = -1;
  const Vector centre = best - a.ldlt().solve(pushes);
  Problem problem = box_problem("bounded-quadratic", 6, -1, 1, 0.3, [&](const Vector& x) {
    return 0.5 * (x - centre).dot(a * (x - centre));
  });
  differentiate_by(problem, [&](const Vector& x) -> Vector { return a * (x - centre); });
  const Matrix root = a.llt().matrixU();
  problem.residuals = [&](const Vector& x) { return Residuals{root * (x - centre), root}; };
  for (const Solver& solver : tao_solvers()) {
    const Solved end = solved(problem, solver, 2000);
    ASSERT_TRUE(end.point) << solver.name << ": " << end.reason;
    EXPECT_LT((*end.point - best).norm(), 1e-5) << solver.name << ": " << end.reason;
    EXPECT_EQ(end.ended, TerminationReason::none) << solver.name;
  }
}

TEST(Tao, SolvesLeastSquaresWithAndWithoutDerivatives) {
  const Problem valley = suite_problem("least-squares-07-rosenbrock-2x2");
  for (const char* const name : {"tao-pounders", "tao-brgn"}) {
    EXPECT_LT(end_of(valley, solver_named(name), 400), 1e-9) << name;
  }
  const Ledger ledger = solved(valley, solver_named("tao-pounders"), 100).ledger;
  EXPECT_GT(ledger.charged, 10);
  EXPECT_EQ(ledger.charged, ledger.derivatives) << "it pays for residuals alone";
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
  run(sphere(2, 3), solver_named("tao-blmvm"), {50}, 0);
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
    if (child == 0) _exit(end_of(sphere(3, 3), solver_named("tao-bqnls"), 100, 1) < 1e-12 ? 0 : 1);
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
  const auto ends_of = [](const char* name) {
    return run(sphere(3, 3), solver_named(name), {200}, 1).terminations;
  };
  const auto ipopt = ends_of("ipopt"), tao = ends_of("tao-blmvm");
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(ends_of("ipopt"), ipopt);
    EXPECT_EQ(ends_of("tao-blmvm"), tao);
  }
}

/// But for the 4 kB that POUNDERS itself loses where the budget ends among its first points.
TEST(Tao, KeepsNothingOfAThousandRuns) {
  for (const Solver& solver : tao_solvers()) {
    const auto use = [&](int times) {
      for (int k = 0; k < times; ++k) {
        solved(k % 2 == 0 ? sphere(5, 3) : half_a_number(), solver, k % 3 == 0 ? 4 : 60);
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
