#include <gtest/gtest.h>

#include <stdexcept>

#include "src/studies/calibration/fit.h"

namespace ricochet::studies::calibration {
namespace {

Problem parabola_of_two() {
  Problem problem;
  problem.name = "parabola";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Constant(1, 10);
  problem.start = Vector::Constant(1, 5);
  problem.evaluate = [](const Vector& x) { return Values{(x[0] - 2) * (x[0] - 2), {}}; };
  return problem;
}

Solver asks_for(double x) {
  Solver solver;
  solver.name = "asks";
  solver.solve = [x](Evaluator& evaluator, const Vector&, Random&) {
    evaluator.values(Vector::Constant(1, x));
    return SolverTermination{"asked"};
  };
  return solver;
}

TEST(BestPoint, IsWhatIsBetterThanTheStart) {
  Problem problem = parabola_of_two();
  BestPoint best = start_of(problem);
  EXPECT_EQ(best.loss, 9);
  improve(problem, asks_for(9), 1, best);
  EXPECT_EQ(best.x[0], 5);
  improve(problem, asks_for(3), 1, best);
  EXPECT_EQ(best.x[0], 3);
  EXPECT_EQ(best.loss, 1);
  improve(problem, asks_for(4), 1, best);
  EXPECT_EQ(best.loss, 1);
  EXPECT_EQ(problem.start[0], 3);  // from the best on
}

TEST(BestPoint, PassesAFailureOn) {
  Problem problem = parabola_of_two();
  BestPoint best = start_of(problem);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  EXPECT_THROW(improve(problem, asks_for(3), 1, best), std::runtime_error);
}

}  // namespace
}  // namespace ricochet::studies::calibration
