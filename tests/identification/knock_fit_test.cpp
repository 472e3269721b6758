#include "src/identification/knock_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/solvers.h"
#include "src/identification/identified_machine.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;

/// A guess that is far from the truth.
Scene wrong_machine() {
  Scene scene = knocking_machine();
  scene.restitution_lower = scene.restitution_upper = 0.4;
  scene.friction = 0.22;
  scene.wall_upper = 0.9e-3;
  return scene;
}

TEST(KnockFit, FindsTheTruthFromMarksAndStrengths) {
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  sensor.strengths = true;
  const KnockRecord record = example_record(sensor);
  const KnockLoss loss(wrong_machine(), record);
  const KnockFit fit = fit_knocks(loss, solver_named(usual_solver));
  const Vector truth = point_of(guess_of(knocking_machine()));
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const double deviation = std::sqrt(fit.covariance(i, i));
    EXPECT_LT(deviation, 0.05) << i;
    EXPECT_LT(std::abs(fit.x[i] - truth[i]), 3 * deviation) << i;
  }
  EXPECT_LT(fit.excess, 0.05);
  EXPECT_LE(fit.loss, loss.at(loss.guess(), 0));
}

TEST(KnockFit, IsTheSameByAnotherSolver) {
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  const KnockRecord record = example_record(sensor, 5);
  const KnockLoss loss(wrong_machine(), record);
  const KnockFit one = fit_knocks(loss, solver_named(usual_solver));
  const KnockFit other = fit_knocks(loss, solver_named("nlopt-lbfgs"));
  EXPECT_NEAR(one.loss, other.loss, 0.05);
}

}  // namespace
}  // namespace ricochet::studies::identification
