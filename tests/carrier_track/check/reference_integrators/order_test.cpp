#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "problems/carrier_track/check/integrator.h"
#include "tests/carrier_track/check/reference_integrators/accuracy.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// Slope of the least-squares line through (ln control, ln error) at control = first / 2^k.
double order(double first, int count, const std::function<double(double)>& error) {
  double x_sum = 0;
  double y_sum = 0;
  double xx = 0;
  double xy = 0;
  for (int k = 0; k < count; ++k) {
    const double control = first * std::pow(0.5, k);
    const double x = std::log(control);
    const double y = std::log(error(control));
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  return (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
}

TEST(Order, OfFixedStepsBetweenWallsIsThatOfTheMethod) {
  // No wall near and no friction: a flight under one harmonic, exact in the event-driven model.
  Scene scene;
  scene.wall_lower = -100.0;
  scene.wall_upper = 100.0;
  scene.start_position = 0.0;
  scene.start_velocity = 0.3;
  scene.disturbance = 2.0;
  scene.disturbance_frequency = 5.0;
  const double true_values = reference(scene).end.position;
  const std::vector<std::pair<std::string, double>> expected = {
      {"semi-implicit-euler", 1}, {"moreau-jean", 2}, {"runge-kutta-4", 4}};
  for (const auto& [name, value] : expected) {
    const Integrator integrator = find_integrator(name);
    const double found = order(0.05, 4, [&](double step) {
      return std::abs(run(integrator, scene, step).end.position - true_values);
    });
    EXPECT_NEAR(found, value, 0.1) << name;
  }
}

TEST(Order, OfFixedStepsThroughImpactsIsOneAtMost) {
  // The naive reflection leaves nothing of the fourth order of Runge-Kutta; Moreau-Jean has the
  // order that theory gives it.
  for (const Integrator& integrator : integrators_by("step [s]")) {
    const double found = order(0.01, 7, [&](double step) {
      const Outcome outcome = run(integrator, bouncing_ball(), step);
      double sum = 0;
      for (std::size_t k = 0; k < 12; ++k) {
        sum += std::abs(outcome.impacts.at(k).time - bounce_time(k));
      }
      return sum;
    });
    EXPECT_GT(found, 0.75) << integrator.name;
    EXPECT_LT(found, 1.25) << integrator.name;
  }
}

TEST(Order, ErrorsOfLocatedImpactTimesShrinkWithTheTolerance) {
  const Scene scene = shaken_gap();
  const Outcome true_values = reference(scene);
  ASSERT_GT(true_values.impacts.size(), 35U);
  for (const Integrator& integrator : integrators_by("relative tolerance")) {
    double last = infinity;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Accuracy accuracy = compare(scene, run(integrator, scene, tolerance), true_values);
      EXPECT_EQ(accuracy.missed + accuracy.spurious, 0) << integrator.name << " " << tolerance;
      const double error = accuracy.impact_time_error.value_or(infinity);
      EXPECT_LT(error, 0.2 * last) << integrator.name << " " << tolerance;
      last = error;
    }
    EXPECT_LT(last, 1e-9) << integrator.name;
  }
}

TEST(Order, OfRosenbrock4IsFourUnderForcesThatVary) {
  // Order four: a tolerance 1e4 times tighter takes 10 times the steps. With the coefficient d4
  // that Boost 1.74 has it is 100 times.
  const Integrator integrator = find_integrator("odeint-rosenbrock4");
  const auto evaluations = [&](double tolerance) {
    return static_cast<double>(run(integrator, shaken_gap(), tolerance).force_evaluations);
  };
  const double ratio = evaluations(1e-10) / evaluations(1e-6);
  EXPECT_GT(ratio, 5);
  EXPECT_LT(ratio, 15);
}

}  // namespace
}  // namespace ricochet::carrier_track
