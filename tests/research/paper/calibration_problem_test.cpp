#include "problems/carrier_track/questions/calibration.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/misfit.h"

namespace ricochet::carrier_track {
namespace {

Freedom some_freedom() {
  return {default_reading().reading,
          {Open::pull, Open::start_velocity, Open::slowest},
          default_reading().constants};
}

TEST(Calibration, PlacesConstantsWithinTheirBoundsAndBack) {
  const Freedom freedom = some_freedom();
  const Constants there = constants_at(freedom, Vector::Constant(3, 0.5));
  EXPECT_NEAR(there[0], std::sqrt(0.01 * 40), 1e-12);  // the pull's size is unknown
  EXPECT_NEAR(there[static_cast<std::size_t>(Open::start_velocity)], 0, 1e-12);
  const Vector back = point_of(freedom, there);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(back[i], 0.5, 1e-12);
  EXPECT_EQ(there[static_cast<std::size_t>(Open::clearance)],
            freedom.held[static_cast<std::size_t>(Open::clearance)]);
}

TEST(Calibration, MinimisesTheMisfit) {
  const Freedom freedom = some_freedom();
  const Problem problem = calibration_problem(freedom);
  EXPECT_EQ(problem.dimension(), 3);
  EXPECT_NEAR(problem.evaluate(problem.start).objective, misfit(freedom.reading, freedom.held),
              1e-6);
}

TEST(Calibration, AsksForTheConstantsOfAReadingThatHoldsTheOthers) {
  const FittedReading& fitted = default_reading();
  const Problem problem = calibration_question(fitted).stated;
  EXPECT_NEAR(problem.best_known.value(), misfit(fitted.reading, fitted.constants), 1e-6);
  EXPECT_LT(*problem.best_known, problem.evaluate(problem.start).objective);
}

TEST(Calibration, HasResidualsWithSlopesInTheBox) {
  const Freedom freedom = some_freedom();
  const Problem problem = calibration_problem(freedom);
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
