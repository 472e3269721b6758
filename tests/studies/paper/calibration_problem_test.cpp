#include <gtest/gtest.h>

#include "src/studies/paper/interpretation.h"
#include "src/studies/paper/loss.h"

namespace ricochet::carrier_track {
namespace {

Parameterisation some_parameterisation() {
  return {default_interpretation().interpretation,
          {Unknown::pull, Unknown::start_velocity, Unknown::counting_limit},
          default_interpretation().constants};
}

TEST(Calibration, PlacesConstantsWithinTheirBoundsAndBack) {
  const Parameterisation parameterisation = some_parameterisation();
  const Parameterisation middle = fit_at(parameterisation, Vector::Constant(3, 0.5));
  const Constants& there = middle.constants;
  EXPECT_NEAR(there[0], std::sqrt(0.01 * 40), 1e-12);  // the pull's size is unknown
  EXPECT_NEAR(there[static_cast<std::size_t>(Unknown::start_velocity)], 0, 1e-12);
  const Vector back = point_of(middle);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(back[i], 0.5, 1e-12);
  EXPECT_EQ(there[static_cast<std::size_t>(Unknown::clearance)],
            parameterisation.constants[static_cast<std::size_t>(Unknown::clearance)]);
}

TEST(Calibration, MinimisesTheLoss) {
  const Parameterisation parameterisation = some_parameterisation();
  const Problem problem = calibration_problem(parameterisation);
  EXPECT_EQ(problem.dimension(), 3);
  EXPECT_NEAR(problem.evaluate(problem.start).objective, loss(parameterisation), 1e-6);
}

TEST(Calibration, AsksForTheConstantsOfAInterpretationThatHoldsTheOthers) {
  const FittedInterpretation& fitted = default_interpretation();
  const Problem problem = calibration_problem(fitted);
  EXPECT_NEAR(problem.best_known.value(), loss(fitted), 1e-6);
  EXPECT_LT(*problem.best_known, problem.evaluate(problem.start).objective);
}

TEST(Calibration, HasResidualsWithSlopesInTheBox) {
  const Parameterisation parameterisation = some_parameterisation();
  const Problem problem = calibration_problem(parameterisation);
  const Residuals r = problem.residuals(problem.start);
  ASSERT_EQ(r.jacobian.rows(), r.values.size());
  const double h = 1e-8;
  Vector near = problem.start;
  near[2] += h;
  const Vector slope = (problem.residuals(near).values - r.values) / h;
  EXPECT_NEAR((slope - r.jacobian.col(2)).norm() / r.jacobian.col(2).norm(), 0, 1e-4);
}

}  // namespace
}  // namespace ricochet::carrier_track
