#include "src/studies/surrogate/derivative_check.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"

namespace ricochet::studies::surrogate {
namespace {

/// (x - 1)^2 + y^3 in [0, 2] x [-1, 3], subject to x y <= 1.
Problem polynomial(const std::string& name) {
  Problem problem;
  problem.name = name;
  problem.lower = Vector(2);
  problem.upper = Vector(2);
  problem.lower << 0, -1;
  problem.upper << 2, 3;
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{std::pow(x[0] - 1, 2) + std::pow(x[1], 3), Vector::Constant(1, x[0] * x[1] - 1)};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    Derivatives d{evaluate(x), Vector(2), Matrix(1, 2)};
    d.gradient << 2 * (x[0] - 1), 3 * x[1] * x[1];
    d.jacobian << x[1], x[0];
    return d;
  };
  return problem;
}

Family family_of(const Problem& problem) {
  return {problem.name, {{problem}}};
}

/// |x| in [-1, 1] with a gradient that knows how far its corner is; `knows`: whether it tells.
Problem corner(bool knows) {
  Problem problem;
  problem.name = "corner-C1";
  problem.lower = Vector::Constant(1, -1);
  problem.upper = Vector::Constant(1, 1);
  problem.evaluate = [](const Vector& x) { return Values{std::abs(x[0]), {}}; };
  problem.differentiate = [knows](const Vector& x) {
    Derivatives d{{std::abs(x[0]), {}}, Vector::Constant(1, x[0] > 0 ? 1 : -1), Matrix(0, 1)};
    if (knows) d.trust.reach = std::abs(x[0]) / 2;
    return d;
  };
  return problem;
}

Vector at(double x) {
  return Vector::Constant(1, x);
}

TEST(DerivativeCheck, ComparesAlongADirectionOfTheUnitBox) {
  Vector point(2), direction(2);
  point << 0.75, 0.5;  // x = 1.5, y = 1
  direction << 0.6, -0.8;
  const auto found = compare(polynomial("polynomial-C3"), point, direction);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].exact, 1 * 2 * 0.6 + 3 * 4 * -0.8, 1e-14);
  EXPECT_NEAR(found[0].difference, found[0].exact, 1e-10);
  EXPECT_NEAR(found[1].exact, 1 * 2 * 0.6 + 1.5 * 4 * -0.8, 1e-14);
  EXPECT_NEAR(found[1].difference, found[1].exact, 1e-10);
  EXPECT_EQ(found[0].cause, Cause::none);
}

TEST(DerivativeCheck, FindsAWrongDerivative) {
  Problem wrong = polynomial("wrong-C1");
  wrong.differentiate = [right = wrong.differentiate](const Vector& x) {
    Derivatives d = right(x);
    d.jacobian(0, 1) *= 1 + 1e-4;
    return d;
  };
  const DerivativeCheckStudy study = study_derivative_check({{family_of(wrong)}, 200, 1});
  ASSERT_EQ(study.rows.size(), 2U);
  EXPECT_EQ(study.rows[0].by_cause[static_cast<std::size_t>(Cause::none)], 200U);
  EXPECT_GT(study.rows[1].by_cause[static_cast<std::size_t>(Cause::unexplained)], 180U);
  EXPECT_EQ(study.unexplained.size(),
            study.rows[1].by_cause[static_cast<std::size_t>(Cause::unexplained)]);
}

TEST(DerivativeCheck, ExplainsACornerByTheReachAlone) {
  const double near = 0.5 + 0.5e-7;  // shorter than the shortest step
  EXPECT_EQ(compare(corner(true), at(near), at(1))[0].cause, Cause::reach);
  EXPECT_EQ(compare(corner(false), at(near), at(1))[0].cause, Cause::unexplained);
  EXPECT_EQ(compare(corner(false), at(0.7), at(1))[0].cause, Cause::none);
}

TEST(DerivativeCheck, CallsASlopeOfNextToNothingFlat) {
  Problem flat = corner(false);
  flat.evaluate = [](const Vector& x) { return Values{5 + 1e-10 * x[0], {}}; };
  flat.differentiate = [](const Vector& x) {
    return Derivatives{{5 + 1e-10 * x[0], {}}, Vector::Constant(1, 3e-10), Matrix(0, 1)};
  };
  EXPECT_EQ(compare(flat, at(0.7), at(1))[0].cause, Cause::flat);
}

TEST(DerivativeCheck, CallsWhatADifferenceCannotTellRounding) {
  Problem coarse = corner(false);  // x, to seven digits
  coarse.evaluate = [](const Vector& x) {
    return Values{1.37e-7 * std::round(x[0] / 1.37e-7), {}};
  };
  coarse.differentiate = [](const Vector& x) {
    return Derivatives{{x[0], {}}, Vector::Constant(1, 1.0), Matrix(0, 1)};
  };
  const DerivativeCheckStudy study = study_derivative_check({{family_of(coarse)}, 1000, 1});
  const auto& by_cause = study.rows[0].by_cause;
  EXPECT_GT(by_cause[static_cast<std::size_t>(Cause::rounding)], 700U);
  EXPECT_EQ(by_cause[static_cast<std::size_t>(Cause::reach)], 0U);
}

TEST(DerivativeCheck, HoldsForTheSurrogateOfTheCases) {
  using namespace carrier_track;
  const std::vector<Machine> machines = all_machines();
  Problem without = polynomial("without-derivatives");
  without.differentiate = nullptr;
  const std::vector<Family> of_machines = families_of(machines);
  const std::vector<Family> families = {of_machines[0], of_machines[1], family_of(without)};
  const DerivativeCheckStudy study = study_derivative_check({families, 72, 7});
  EXPECT_EQ(study.families, 2U);
  EXPECT_EQ(study.points, 72U);
  ASSERT_EQ(study.rows.size(), 3U);
  for (const DerivativeErrors& row : study.rows) {
    EXPECT_EQ(row.errors.size(), 36U);
    EXPECT_EQ(row.by_cause[static_cast<std::size_t>(Cause::unexplained)], 0U) << row.family;
    EXPECT_LT(row.errors[18], 1e-10) << row.family;
  }
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const DerivativeCheckStudy single = study_derivative_check({families, 72, 7});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(study.rows[k].errors, single.rows[k].errors);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
