#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

TEST(PerturbedStart, LiesAThousandthOfTheBoxAwayAndInside) {
  for (Problem problem : random_problems()) {
    const Vector width = problem.upper - problem.lower;
    for (const Vector& start : {Vector(problem.start), problem.lower, problem.upper}) {
      problem.start = start;
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Problem moved = perturbed_start().perturbed(problem, seed);
        EXPECT_NEAR((moved.start - start).cwiseQuotient(width).norm(), 1e-3, 1e-12);
        EXPECT_TRUE((moved.start.array() >= problem.lower.array()).all());
        EXPECT_TRUE((moved.start.array() <= problem.upper.array()).all());
        EXPECT_EQ(moved.evaluate(start).objective, problem.evaluate(start).objective);
        EXPECT_EQ(moved.smoothed(0.1).start, moved.start);
      }
    }
  }
}

TEST(PerturbedStart, HasNoPreferredDirection) {
  Random random(1);
  const Problem problem = random_problem(random, {.dimension = 3});
  const Vector width = problem.upper - problem.lower;
  constexpr int size = 20'000;
  Matrix moments = Matrix::Zero(3, 3);
  Vector mean = Vector::Zero(3);
  for (std::uint64_t seed = 0; seed < size; ++seed) {
    const Problem moved = perturbed_start().perturbed(problem, seed);
    const Vector direction = 1e3 * (moved.start - problem.start).cwiseQuotient(width);
    mean += direction / size;
    moments += direction * direction.transpose() / size;
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5 * std::sqrt(1.0 / 3 / size));
  EXPECT_LT((moments - Matrix::Identity(3, 3) / 3).cwiseAbs().maxCoeff(),
            5 * 0.3 / std::sqrt(size));
}

TEST(PerturbedStart, IsWhereEveryRunBegins) {
  Random random(1);
  const Problem problem = random_problem(random, {});
  std::vector<Vector> starts;
  Solver solver;
  solver.name = "asks-at-its-start";
  solver.solve = [&starts](Evaluator& evaluator, const Vector& start,
                           Random&) -> SolverTermination {
    starts.push_back(start);
    evaluator.values(start);
    return {};
  };
  for (const int number : {0, 1, 2}) {
    const Problem moved = perturbed_start().perturbed(problem, static_cast<std::uint64_t>(number));
    starts.clear();
    run(moved, solver, {2}, number);
    EXPECT_EQ(starts.at(0), moved.start) << number;
    EXPECT_GT((starts.at(1) - moved.start).norm(), 0.01) << "the solver's second start";
  }
}

}  // namespace
}  // namespace ricochet
