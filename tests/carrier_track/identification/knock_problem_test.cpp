#include "problems/carrier_track/identification/knock_problem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

TEST(KnockProblem, HasTheLossOfItsCoordinates) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const Vector centre = example_point(record);
  const KnockCoordinates coordinates = knock_coordinates(loss, centre, 0, loss.free());
  const Problem problem = knock_problem(loss, coordinates, 0);
  ASSERT_EQ(problem.dimension(), 10);
  EXPECT_EQ(problem.evaluate(problem.start).objective, loss.at(centre, 0));
  const Vector z = Vector::Constant(10, 0.1);
  EXPECT_EQ(problem.evaluate(z).objective, loss.at(coordinates.at(z), 0));
  const Derivatives there = problem.differentiate(z);
  for (Eigen::Index i = 0; i < 10; ++i) {
    Vector up = z, down = z;
    up[i] += 1e-4;
    down[i] -= 1e-4;
    EXPECT_NEAR(there.gradient[i],
                (problem.evaluate(up).objective - problem.evaluate(down).objective) / 2e-4, 1e-3);
  }
}

TEST(KnockProblem, IsScaledByTheInformation) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const Vector centre = example_point(record);
  const KnockCoordinates coordinates = knock_coordinates(loss, centre, 0, loss.free());
  const Matrix scaled = coordinates.directions.transpose() * loss.information(centre).information *
                        coordinates.directions;
  EXPECT_LT((scaled - Matrix::Identity(10, 10)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(KnockProblem, StaysWhereASimulationEnds) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  KnockCoordinates coordinates = knock_coordinates(loss, example_point(record), 0, {0, 1});
  coordinates.directions *= 1e6;
  const KnockUnknowns far = unknowns_at(coordinates.at(Vector::Constant(2, 10)));
  EXPECT_LT(far.restitution, 0.99);
  EXPECT_LT(far.friction, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
