#include "src/research/long_run/border_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/problems/default_machine.h"
#include "ricochet/regimes.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;

TEST(BorderLaw, ComparesBordersWithTheirLawAndTheFormula) {
  const LawComparison law = compared(default_machine(), {0.1, 0.5, 0.9}, {0.1, 0.4});
  ASSERT_EQ(law.points.size(), 6U);
  Scene machine = default_machine();
  machine.disturbance = 0;
  machine.restitution_lower = machine.restitution_upper = 0.5;
  machine.friction = 0.4;
  const LawPoint& point = law.points[4];
  EXPECT_EQ(point.restitution, 0.5);
  EXPECT_EQ(point.friction, 0.4);
  EXPECT_DOUBLE_EQ(*point.border, *quiet_up_to(machine, 2));
  EXPECT_LT(law.law_worst, 1e-9);
  // By its definition, from the constants.
  const auto error = [](const FormulaWorth& f, const LawPoint& p) {
    const double formula =
        f.c * std::sqrt((1 - p.restitution) / (1 + p.restitution)) * std::exp(f.k * p.friction);
    return std::log(formula / *p.border);
  };
  double squares = 0;
  for (const LawPoint& p : law.points) squares += std::pow(error(law.of_paper, p), 2);
  EXPECT_NEAR(law.of_paper.rms, std::sqrt(squares / 6), 1e-12);
  const double low = error(law.of_paper, law.points[1]), high = error(law.of_paper, law.points[4]);
  EXPECT_NEAR(law.of_paper.rms_between, std::sqrt((low * low + high * high) / 2), 1e-12);
  EXPECT_NEAR(std::abs(law.of_paper.worst_between), std::max(std::abs(low), std::abs(high)), 1e-12);
  EXPECT_LE(law.of_all.rms, law.of_corners.rms);
  EXPECT_LE(law.of_all.rms, law.of_paper.rms);
}

TEST(BorderLaw, FitsTheFormulaToThePaper) {
  const LawComparison law = compared(default_machine(), {0.1, 0.3, 0.9}, {0.1, 0.4});
  // Two frictions: the line goes through the means of both.
  double low = 0, high = 0;
  for (const double w : {9.0, 8.0, 7.3}) low += std::log(w / std::sqrt(0.9 / 1.1)) / 6;
  for (const double w : {2.0, 1.9, 2.0}) low += std::log(w / std::sqrt(0.1 / 1.9)) / 6;
  for (const double w : {13.0, 11.9}) high += std::log(w / std::sqrt(0.9 / 1.1)) / 4;
  for (const double w : {3.1, 3.0}) high += std::log(w / std::sqrt(0.1 / 1.9)) / 4;
  EXPECT_NEAR(law.of_paper.k, (high - low) / 0.3, 1e-9);
  EXPECT_NEAR(law.of_paper.c, std::exp(low - 0.1 * law.of_paper.k), 1e-9);
}

}  // namespace
}  // namespace ricochet::studies::long_run
