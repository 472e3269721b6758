#include "src/research/calibration/variants/ode45.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ricochet::studies::variants {
namespace {

/// The worst error of x'' = -x from (1, 0) over 20 s, and the longest step.
struct Swinging {
  double error = 0, longest = 0;
  std::int64_t steps = 0;
};

Swinging swinging(const OdeTolerances& tolerances) {
  Ode45 method(
      [](const OdeState& x, double) {
        return OdeState{x[1], -x[0]};
      },
      {1, 0}, 20, tolerances);
  Swinging result;
  while (method.time() < 20) {
    const double before = method.time();
    method.step();
    result.longest = std::max(result.longest, method.time() - before);
    result.error = std::max(result.error, std::abs(method.state()[0] - std::cos(method.time())));
  }
  EXPECT_EQ(method.time(), 20);
  result.steps = method.steps();
  return result;
}

TEST(Ode45, IsAsExactAsItsTolerances) {
  const Swinging usual = swinging({});
  const Swinging tight = swinging({1e-6, 1e-9});
  EXPECT_LT(usual.error, 0.1);
  EXPECT_GT(usual.error, 1e-3) << "the default is no exact solution";
  EXPECT_LT(tight.error, 1e-4);
  EXPECT_GT(2 * tight.steps, 5 * usual.steps) << "a thousandth of the error: 4 times the steps";
}

TEST(Ode45, TakesNoStepLongerThanATenthOfTheWindow) {
  Ode45 method([](const OdeState&, double) { return OdeState{1, 0}; }, {0, 1}, 5, {});
  int steps = 0;
  while (method.time() < 5) {
    const double before = method.time();
    method.step();
    EXPECT_LE(method.time() - before, 0.55);  // the last is stretched by a tenth
    ++steps;
  }
  EXPECT_GE(steps, 10);
  EXPECT_NEAR(method.state()[0], 5, 1e-12);
}

TEST(Ode45, GivesUpWhereNoStepIsSmallEnough) {
  Ode45 method([](const OdeState& x, double) { return OdeState{x[0] * x[0], 0}; }, {1, 0}, 2, {});
  EXPECT_THROW(while (method.time() < 2) method.step(), std::runtime_error) << "1 / (1 - t)";
}

}  // namespace
}  // namespace ricochet::studies::variants
