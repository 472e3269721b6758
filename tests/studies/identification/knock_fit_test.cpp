#include "src/identification/knock_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/identification/identified_machine.h"
#include "tests/carrier_track/identification/example_record.h"
#include "tests/carrier_track/regimes/random_machine.h"

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

/// Within 30 % of restitution and clearance, 20 % of friction.
Scene guess_near(Scene scene, Random& random) {
  const auto share = [&](double reach) { return 1 + reach * (2 * uniform(random) - 1); };
  scene.restitution_lower = scene.restitution_upper = scene.restitution_lower * share(0.3);
  scene.friction *= share(0.2);
  scene.wall_upper *= share(0.3);
  return scene;
}

/// Six speeds, each for ten seconds: the record in which a neighbouring minimum, 10 % off in the
/// friction, once was taken for the best.
TEST(KnockFit, FindsTheTruthBesideANeighbouringMinimum) {
  std::vector<SpeedKnot<double>> steps = {{0, 2}};
  for (int k = 0; k < 6; ++k) {
    const double speed = 2 + 13.0 * k / 5;
    if (k > 0) steps.push_back({10.0 * k + 1, speed});
    steps.push_back({10.0 * (k + 1), speed});
  }
  Random random(10);
  Scene truth = knocking_machine();
  truth.phase = 2 * std::numbers::pi * uniform(random);
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  const KnockRecord record = synthetic_knocks(truth, steps, sensor, random);
  const KnockLoss loss(guess_near(truth, random), record);
  const KnockFit fit = fit_knocks(loss, solver_named(usual_solver));
  EXPECT_NEAR(fit.x[coordinate::friction], std::log(truth.friction), 0.02);
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

/// Without loss, and pulled as hard as it is thrown, the impacts of a minute depend on the
/// constants by more than a number can hold.
TEST(KnockFit, IsRefusedWhereImpactsDependOnTheConstantsWithoutLimit) {
  Scene elastic = strange_machine(90);
  elastic.fidelity = Fidelity::impact;
  elastic.rule = CountRule::impacts;
  elastic.disturbance = 0;
  elastic.restitution_lower = elastic.restitution_upper = 1;
  const std::vector<SpeedKnot<double>> speed = {{0, 4.6}, {60, 16.3}};
  Random random(90);
  const KnockRecord record = synthetic_knocks(elastic, speed, {}, random);
  const KnockLoss loss(elastic, record);
  EXPECT_THROW(fit_knocks(loss, solver_named(usual_solver)), InputError);
}

}  // namespace
}  // namespace ricochet::studies::identification
