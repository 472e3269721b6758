#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/studies/fireworks/study.h"

namespace ricochet::studies::fireworks {
namespace {

double value(const std::string& name, const Vector& x) {
  return benchmark_function(name, x.size()).evaluate(x).objective;
}

TEST(BenchmarkFunctions, AreZeroAtTheirBestPoint) {
  for (const char* name :
       {"Sphere", "Rastrigin", "Griewank", "Ellipse", "Cigar", "Tablet", "Ackley"}) {
    EXPECT_NEAR(value(name, Vector::Zero(30)), 0, 1e-14) << name;
  }
  EXPECT_EQ(value("Rosenbrock", Vector::Ones(30)), 0);
  EXPECT_EQ(value("Schwefel", Vector::Ones(30)), 0);
}

TEST(BenchmarkFunctions, HaveTheValuesOfTheirFormulas) {
  const Vector x{{1, 2, 3}};
  EXPECT_EQ(value("Sphere", x), 14);
  EXPECT_EQ(value("Rosenbrock", x), 100 + 0 + 100 + 1);
  EXPECT_NEAR(value("Rastrigin", x), 14, 1e-12);
  EXPECT_NEAR(value("Griewank", x),
              1 + 14.0 / 4000 - std::cos(1) * std::cos(std::sqrt(2)) * std::cos(std::sqrt(3)),
              1e-14);
  EXPECT_NEAR(value("Ellipse", x), 1 + 100 * 4 + 1e4 * 9, 1e-9);
  EXPECT_EQ(value("Cigar", x), 1 + 13e4);
  EXPECT_EQ(value("Tablet", x), 13 + 1e4);
  EXPECT_EQ(value("Schwefel", x), 0 + (9 + 1) + (64 + 4));
  EXPECT_NEAR(value("Ackley", x), 20 - 20 * std::exp(-0.2 * std::sqrt(14.0 / 3)), 1e-12);
  EXPECT_THROW(benchmark_function("Spear", 3), std::out_of_range);
}

TEST(BenchmarkFunctions, AreMovedByTheirShift) {
  const Problem problem = shifted_sphere(5, 2);
  EXPECT_EQ(problem.evaluate(Vector{{5, 5}}).objective, 0);
  EXPECT_EQ(problem.evaluate(Vector{{4, 7}}).objective, 5);
}

}  // namespace
}  // namespace ricochet::studies::fireworks
