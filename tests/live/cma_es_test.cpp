#include "src/live/cma_es.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/evaluator.h"

namespace ricochet::live {
namespace {

/// A problem of one variable on [-3, 5].
Problem on_a_line(const std::function<double(double)>& f) {
  Problem problem;
  problem.name = "line";
  problem.lower = Vector::Constant(1, -3);
  problem.upper = Vector::Constant(1, 5);
  problem.start = Vector::Constant(1, 4);
  problem.evaluate = [f](const Vector& x) { return Values{f(x[0]), {}}; };
  return problem;
}

/// Evaluations until a run ends by itself, and its best point.
struct Ended {
  double best;
  std::int64_t evaluations;
};

Ended ended(const Problem& problem, std::uint64_t seed) {
  Evaluator evaluator(problem, Budget{10'000});
  Random random(seed);
  cma_es().solve(evaluator, problem.start, random);
  EXPECT_FALSE(evaluator.over());
  return {(*evaluator.best_shown())[0], evaluator.ledger().charged};
}

TEST(CmaEs, ConvergesToTheMinimumOfAParabola) {
  const Problem problem = on_a_line([](double x) { return (x - 1.25) * (x - 1.25); });
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Ended run = ended(problem, seed);
    EXPECT_NEAR(run.best, 1.25, 1e-4) << seed;
    EXPECT_LT(run.evaluations, 400) << seed;
  }
}

TEST(CmaEs, AsksTheOrderOfValuesAlone) {
  const auto parabola = [](double x) { return (x + 0.5) * (x + 0.5); };
  const Problem plain = on_a_line(parabola);
  const Problem bent = on_a_line([&](double x) { return std::cbrt(parabola(x)) - 7; });
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(ended(plain, seed).best, ended(bent, seed).best);
  }
}

TEST(CmaEs, GrowsItsStepOnASlope) {
  // From the middle with steps of a hundredth of the box, it must arrive at the end.
  Problem problem = on_a_line([](double x) { return -x; });
  problem.start = Vector::Constant(1, 1);
  Evaluator evaluator(problem, Budget{100});
  Random random(3);
  cma_es(0.01).solve(evaluator, problem.start, random);
  EXPECT_EQ((*evaluator.best_shown())[0], 5);
}

TEST(CmaEs, EndsWhereTheEvaluatorRefuses) {
  const Problem problem = on_a_line([](double x) { return x * x; });
  Evaluator evaluator(problem, Budget{7});
  Random random(1);
  cma_es().solve(evaluator, problem.start, random);
  EXPECT_EQ(evaluator.ledger().charged, 7);
  EXPECT_TRUE(evaluator.over());
}

}  // namespace
}  // namespace ricochet::live
