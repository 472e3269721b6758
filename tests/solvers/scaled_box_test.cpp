#include "solvers/scaled_box.h"

#include <gtest/gtest.h>

#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(ScaledBox, TakesCornersToCornersAndBack) {
  Problem problem = sphere(2, 3);
  problem.lower = Vector{{-100, 2}};
  problem.upper = Vector{{300, 4}};
  Evaluator evaluator(problem, {10});
  const ScaledBox box(evaluator);
  EXPECT_EQ(box.to_scaled(problem.lower), Vector::Zero(2));
  EXPECT_EQ(box.to_scaled(problem.upper), Vector::Ones(2));
  EXPECT_EQ(box.from_scaled(Vector{{0.25, 0.5}}), (Vector{{0, 3}}));
}

TEST(ScaledBox, HasAPlaceForACoordinateWithoutWidth) {
  Problem problem = sphere(2, 3);
  problem.lower = Vector{{-100, 2}};
  problem.upper = Vector{{300, 2}};
  Evaluator evaluator(problem, {10});
  for (const auto& [name, coordinates] : names_of(Coordinates{})) {
    ScaledBox box(evaluator, coordinates);
    EXPECT_EQ(box.to_scaled(Vector{{100, 2}})[1], 0) << name;
    EXPECT_EQ(box.from_scaled(box.lower()), problem.lower) << name;
    EXPECT_EQ(box.from_scaled(box.upper()), problem.upper) << name;
    EXPECT_LT(box.lower()[1], box.upper()[1]) << name << ": libraries refuse equal bounds";
    EXPECT_EQ(box.derivatives(box.upper())->gradient[1], 0) << name;
  }
}

TEST(ScaledBox, IsTheBoxOfTheProblemInItsOwnCoordinates) {
  Problem problem = sphere(2, 3);
  problem.lower = Vector{{-100, 2}};
  problem.upper = Vector{{300, 4}};
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator, Coordinates::own);
  EXPECT_EQ(box.lower(), problem.lower);
  EXPECT_EQ(box.upper(), problem.upper);
  const Vector x{{0.1, 3.7}};
  EXPECT_EQ(box.to_scaled(x), x);
  EXPECT_EQ(box.from_scaled(x), x);
  EXPECT_EQ(box.derivatives(x)->gradient, problem.differentiate(x).gradient);
}

TEST(ScaledBox, KeepsTheRatioOfTheSidesWhenTheLongestHasLengthOne) {
  Problem problem = sphere(2, 3);
  problem.lower = Vector{{-100, 2}};
  problem.upper = Vector{{300, 4}};
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator, Coordinates::even);
  EXPECT_EQ(box.lower(), Vector::Zero(2));
  EXPECT_EQ(box.upper(), (Vector{{1, 0.005}}));
  EXPECT_EQ(box.from_scaled(Vector{{0.25, 0.0025}}), (Vector{{0, 3}}));
  EXPECT_EQ(box.derivatives(Vector{{0.5, 0}})->gradient, 400 * (Vector{{194, -2}}));
}

TEST(ScaledBox, MovesAPointIntoTheBox) {
  const Problem problem = sphere(2, 3);  // on [-100, 100]^2
  Evaluator evaluator(problem, {10});
  EXPECT_EQ(ScaledBox(evaluator).to_scaled(Vector{{-300, 300}}), (Vector{{0, 1}}));
}

TEST(ScaledBox, ScalesDerivativesByTheWidth) {
  const Problem problem = disc();  // on [-2, 2]^2
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator);
  const auto seen = box.derivatives(Vector{{0.75, 0.25}});  // x = (1, -1)
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->gradient, Vector::Constant(2, 4));
  EXPECT_EQ(seen->jacobian.row(0).transpose(), (Vector{{8, -8}}));
}

TEST(ScaledBox, ScalesTheDerivativesOfResidualsByTheWidth) {
  const Problem problem = sphere(2, 3);  // on [-100, 100]^2
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator);
  const auto seen = box.residuals(Vector{{0.75, 0.25}});  // x = (50, -50)
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->values, std::sqrt(2.0) * Vector({{47, -53}}));
  EXPECT_EQ(seen->jacobian, 200 * std::sqrt(2.0) * Matrix::Identity(2, 2));
}

TEST(ScaledBox, ShowsAConstraintAtItsLimitAsZero) {
  const Problem problem = disc();
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator);
  EXPECT_EQ(box.values(Vector{{0.75, 0.5}})->constraints[0], 0);
  EXPECT_EQ(box.derivatives(Vector{{0.5, 0.25}})->values.constraints[0], 0);
}

TEST(ScaledBox, DoesNotAskTheEvaluatorWhereThePointIsNotFinite) {
  const Problem problem = sphere(1, 3);
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator);
  EXPECT_FALSE(box.values(Vector::Constant(1, not_a_number)));
  EXPECT_FALSE(box.derivatives(Vector::Constant(1, not_a_number)));
  EXPECT_FALSE(box.residuals(Vector::Constant(1, not_a_number)));
  EXPECT_FALSE(box.over()) << "the run goes on from another start";
}

TEST(Finite, LooksAtEveryNumber) {
  const Values good{1.0, Vector::Ones(1)};
  EXPECT_TRUE(finite(Derivatives{good, Vector::Ones(2), Matrix::Ones(1, 2)}));
  EXPECT_FALSE(finite(Values{not_a_number, {}}));
  EXPECT_FALSE(finite(Values{1.0, Vector::Constant(1, not_a_number)}));
  EXPECT_FALSE(finite(Derivatives{good, Vector::Constant(2, not_a_number), Matrix::Ones(1, 2)}));
  EXPECT_FALSE(finite(Derivatives{good, Vector::Ones(2), Matrix::Constant(1, 2, not_a_number)}));
  EXPECT_TRUE(finite(Residuals{Vector::Ones(1), Matrix::Ones(1, 2)}));
  EXPECT_FALSE(finite(Residuals{Vector::Constant(1, not_a_number), Matrix::Ones(1, 2)}));
  EXPECT_FALSE(finite(Residuals{Vector::Ones(1), Matrix::Constant(1, 2, not_a_number)}));
}

}  // namespace
}  // namespace ricochet
