#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/surrogate/study.h"

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

std::string cause(const Problem& problem, double point) {
  return derivatives_at("", problem, at(point), at(1))[0].text("cause");
}

/// How many rows of a function have a cause.
std::size_t with_cause(const Table& table, const char* function, const char* cause) {
  return where(where(table, "function", value_of(function)), "cause", value_of(cause)).rows.size();
}

TEST(Derivatives, AreComparedAlongADirectionOfTheUnitBox) {
  Vector point(2), direction(2);
  point << 0.75, 0.5;  // x = 1.5, y = 1
  direction << 0.6, -0.8;
  const Table found = derivatives_at("", polynomial("polynomial-C3"), point, direction);
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_NEAR(found[0].number("exact"), 1 * 2 * 0.6 + 3 * 4 * -0.8, 1e-14);
  EXPECT_NEAR(found[0].number("difference"), found[0].number("exact"), 1e-10);
  EXPECT_NEAR(found[1].number("exact"), 1 * 2 * 0.6 + 1.5 * 4 * -0.8, 1e-14);
  EXPECT_NEAR(found[1].number("difference"), found[1].number("exact"), 1e-10);
  EXPECT_EQ(found[0].text("cause"), "none");
}

TEST(Derivatives, ThatAreWrongAreFound) {
  Problem wrong = polynomial("wrong-C1");
  wrong.differentiate = [right = wrong.differentiate](const Vector& x) {
    Derivatives d = right(x);
    d.jacobian(0, 1) *= 1 + 1e-4;
    return d;
  };
  const Table table = derivatives({family_of(wrong)}, 200, 1);
  EXPECT_EQ(with_cause(table, "objective", "none"), 200U);
  EXPECT_GT(with_cause(table, "constraints", "unexplained"), 180U);
  report::Results results;
  add_derivatives(results, table);
  EXPECT_EQ(results.table("unexplained")->rows.size(),
            with_cause(table, "constraints", "unexplained"));
  EXPECT_EQ((*results.table("derivatives"))[1].number("derivatives"), 200);
  EXPECT_EQ(*results.value("unexplained-outliers"),
            (*results.table("derivatives"))[1]["unexplained"]);
}

TEST(Derivatives, AtACornerAreExplainedByTheReachAlone) {
  const double near = 0.5 + 0.5e-7;  // shorter than the shortest step
  EXPECT_EQ(cause(corner(true), near), "reach");
  EXPECT_EQ(cause(corner(false), near), "unexplained");
  EXPECT_EQ(cause(corner(false), 0.7), "none");
}

TEST(Derivatives, OfNextToNothingAreFlat) {
  Problem flat = corner(false);
  flat.evaluate = [](const Vector& x) { return Values{5 + 1e-10 * x[0], {}}; };
  flat.differentiate = [](const Vector& x) {
    return Derivatives{{5 + 1e-10 * x[0], {}}, Vector::Constant(1, 3e-10), Matrix(0, 1)};
  };
  EXPECT_EQ(cause(flat, 0.7), "flat");
}

TEST(Derivatives, ThatDifferencesCannotTellAreRounding) {
  Problem coarse = corner(false);  // x, to seven digits
  coarse.evaluate = [](const Vector& x) {
    return Values{1.37e-7 * std::round(x[0] / 1.37e-7), {}};
  };
  coarse.differentiate = [](const Vector& x) {
    return Derivatives{{x[0], {}}, Vector::Constant(1, 1.0), Matrix(0, 1)};
  };
  const Table table = derivatives({family_of(coarse)}, 1000, 1);
  EXPECT_GT(with_cause(table, "objective", "rounding"), 700U);
  EXPECT_EQ(with_cause(table, "objective", "reach"), 0U);
}

TEST(Derivatives, OfTheCasesSurrogatesHoldOnAnyNumberOfThreads) {
  using namespace carrier_track;
  Problem without = polynomial("without-derivatives");
  without.differentiate = nullptr;
  const std::vector<Family> of_machines = families_of(all_machines());
  const std::vector<Family> families = {of_machines[0], of_machines[1], family_of(without)};
  const Table table = derivatives(families, 72, 7);
  ASSERT_EQ(table.rows.size(), 36U + 2 * 36U);
  EXPECT_TRUE(where(table, "cause", value_of("unexplained")).rows.empty());
  each_row(aggregated(table, {"family", "function"}, {{{"half"}, "relative", median_of}}),
           [](const Row& row) { EXPECT_LT(row.number("half"), 1e-10) << row.text("family"); });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(derivatives(families, 72, 7).rows, table.rows);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
