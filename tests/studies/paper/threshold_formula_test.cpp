#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/paper/theory.h"

namespace ricochet::carrier_track::inline paper {
namespace {

double loss(double restitution) {
  return (1 - restitution) / (1 + restitution);
}

/// Two restitutions, two frictions, three disturbances; thresholds by `threshold(point)`.
template <class Threshold>
std::vector<ThresholdPoint> made_by(Threshold threshold) {
  std::vector<ThresholdPoint> points;
  for (const double e : {0.1, 0.9}) {
    for (const double mu : {0.1, 0.4}) {
      for (const double disturbance : {0.0, 0.1, 1.0}) {
        ThresholdPoint point{fmt::format("P{}", points.size()), e, mu, disturbance, 1.0};
        point.threshold = threshold(point);
        points.push_back(point);
      }
    }
  }
  return points;
}

Formula formula_of(const std::string& words) {
  for (const Formula& formula : all_formulas()) {
    if (formula.words == words) return formula;
  }
  throw std::out_of_range(words);
}

void expect_recovered(const std::string& words, const std::vector<ThresholdPoint>& points,
                      const std::vector<double>& constants, double tolerance = 1e-10) {
  const auto fit = fitted(formula_of(words), points);
  ASSERT_TRUE(fit) << words;
  ASSERT_EQ(fit->constants.size(), constants.size()) << words;
  for (std::size_t k = 0; k < constants.size(); ++k) {
    EXPECT_NEAR(fit->constants[k], constants[k], tolerance) << words << " " << k;
  }
  EXPECT_NEAR(fit->errors.rms, 0, tolerance) << words;
  EXPECT_NEAR(fit->errors.explained.value(), 1, tolerance) << words;
  EXPECT_NEAR(fit->left_out.value(), 0, tolerance) << words;
}

TEST(ThresholdFormula, RecoversTheConstantsThatMadeThePoints) {
  expect_recovered("w = c √R",
                   made_by([](const auto& p) { return 7 * std::sqrt(loss(p.restitution)); }), {7});
  expect_recovered("w = c Rᵖ",
                   made_by([](const auto& p) { return 7 * std::pow(loss(p.restitution), 0.3); }),
                   {7, 0.3});
  expect_recovered("w = c √R exp(k μ)", made_by([](const auto& p) {
                     return 7 * std::sqrt(loss(p.restitution)) * std::exp(1.2 * p.friction);
                   }),
                   {7, 1.2});
  const auto all = made_by([](const auto& p) {
    return 7 * std::sqrt(loss(p.restitution)) * std::exp(1.2 * p.friction - 0.4 * p.disturbance);
  });
  expect_recovered("w = c √R exp(k μ + d D)", all, {7, 1.2, -0.4});
  expect_recovered("w = c Rᵖ exp(k μ + d D)", all, {7, 0.5, 1.2, -0.4});
}

/// The page says that √R, which bouncing on one wall without friction has, explains nothing.
TEST(ThresholdFormula, IsOfNoBodyThatThePullBringsDown) {
  for (const Case& c : all_cases()) {
    const Scene scene = scene_of(c, default_interpretation().scene);
    EXPECT_GT(scene.friction * scene.normal_force, scene.pull) << c.id;
  }
}

TEST(ThresholdFormula, SaysOfAConstantThatItExplainsNothing) {
  // ln w is 0 and 2 by halves: their mean is 1, and without a point of four it is 4/3 or 2/3.
  const double high = std::exp(2.0);
  const std::vector<ThresholdPoint> points = {{"A", 0.1, 0.1, 0, 1.0},
                                              {"B", 0.1, 0.1, 0, 1.0},
                                              {"C", 0.1, 0.1, 0, high},
                                              {"D", 0.1, 0.1, 0, high}};
  const auto fit = fitted(formula_of("w = c"), points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->constants.at(0), std::exp(1.0), 1e-12);
  EXPECT_NEAR(fit->errors.explained.value(), 0, 1e-12);
  EXPECT_NEAR(fit->errors.rms, 1, 1e-12);
  EXPECT_NEAR(fit->left_out.value(), 4.0 / 3, 1e-12);
}

TEST(ThresholdFormula, MeasuresErrorsInTheLogarithm) {
  const std::vector<ThresholdPoint> points = {{"A", 0.1, 0.1, 0, 1.0}, {"B", 0.1, 0.1, 0, 4.0}};
  const PredictionErrors errors = errors_of(points, {2.0, 1.0});
  const double ln2 = std::log(2.0);
  EXPECT_NEAR(errors.rms, ln2 * std::sqrt(2.5), 1e-12);   // ln 2 and -ln 4
  EXPECT_NEAR(errors.explained.value(), 1 - 2.5, 1e-12);  // variance (ln 2)^2: worse than the mean
}

TEST(ThresholdFormula, ExplainsNoShareOfAVarianceThatIsNotThere) {
  EXPECT_FALSE(errors_of({{"A", 0.1, 0.1, 0, 2.0}}, {3.0}).explained);
}

TEST(ThresholdFormula, FitsNothingThatThePointsDoNotDetermine) {
  std::vector<ThresholdPoint> points = {
      {"A", 0.1, 0.1, 0, 1.0}, {"B", 0.9, 0.1, 0, 2.0}, {"C", 0.5, 0.1, 0, 3.0}};
  EXPECT_FALSE(fitted(friction_formula(), points)) << "one friction only";
  EXPECT_TRUE(fitted(square_root_formula(), points));
  points.pop_back();
  EXPECT_FALSE(fitted(formula_of("w = c Rᵖ"), points)) << "no more points than constants";
  points = {{"A", 0.1, 0.1, 0, 1.0}, {"B", 0.1, 0.1, 0, 2.0}, {"C", 0.9, 0.1, 0, 3.0}};
  const auto fit = fitted(formula_of("w = c Rᵖ"), points);
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->left_out) << "without C there is one restitution";
}

}  // namespace
}  // namespace ricochet::carrier_track::inline paper
