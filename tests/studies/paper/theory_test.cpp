#include "src/studies/paper/theory.h"

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/paper/interpretation.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track::inline paper {
namespace {

Formula formula_of(const std::string& words) {
  for (const Formula& formula : all_formulas()) {
    if (formula.words == words) return formula;
  }
  throw std::out_of_range(words);
}

TEST(ThresholdFormula, RecoversTheConstantsThatMadeThePoints) {
  struct Made {
    std::string words;
    double power, by_friction, by_disturbance;
    std::vector<double> constants;
  };
  for (const Made& made : {Made{"w = c √R", 0.5, 0, 0, {7}},
                           {"w = c Rᵖ", 0.3, 0, 0, {7, 0.3}},
                           {"w = c √R exp(k μ)", 0.5, 1.2, 0, {7, 1.2}},
                           {"w = c √R exp(k μ + d D)", 0.5, 1.2, -0.4, {7, 1.2, -0.4}},
                           {"w = c Rᵖ exp(k μ + d D)", 0.5, 1.2, -0.4, {7, 0.5, 1.2, -0.4}}}) {
    std::vector<ThresholdPoint> points;
    for (const double e : {0.1, 0.9}) {
      for (const double mu : {0.1, 0.4}) {
        for (const double disturbance : {0.0, 0.1, 1.0}) {
          const double threshold =
              7 * std::pow((1 - e) / (1 + e), made.power) *
              std::exp(made.by_friction * mu + made.by_disturbance * disturbance);
          points.push_back({"P", e, mu, disturbance, threshold});
        }
      }
    }
    const auto fit = fitted(formula_of(made.words), points);
    SCOPED_TRACE(made.words);
    ASSERT_TRUE(fit);
    EXPECT_THAT(fit->constants, testing::Pointwise(testing::DoubleNear(1e-10), made.constants));
    EXPECT_NEAR(fit->errors.rms, 0, 1e-10);
    EXPECT_NEAR(fit->errors.explained.value(), 1, 1e-10);
    EXPECT_NEAR(fit->left_out.value(), 0, 1e-10);
  }
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
  const auto fit = fitted(formula_of("w = c"), {{"A", 0.1, 0.1, 0, 1.0},
                                                {"B", 0.1, 0.1, 0, 1.0},
                                                {"C", 0.1, 0.1, 0, high},
                                                {"D", 0.1, 0.1, 0, high}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->constants.at(0), std::exp(1.0), 1e-12);
  EXPECT_NEAR(fit->errors.explained.value(), 0, 1e-12);
  EXPECT_NEAR(fit->errors.rms, 1, 1e-12);
  EXPECT_NEAR(fit->left_out.value(), 4.0 / 3, 1e-12);
}

TEST(ThresholdFormula, MeasuresErrorsInTheLogarithm) {
  const std::vector<ThresholdPoint> points = {{"A", 0.1, 0.1, 0, 1.0}, {"B", 0.1, 0.1, 0, 4.0}};
  const PredictionErrors errors = errors_of(points, {2.0, 1.0});
  EXPECT_NEAR(errors.rms, std::log(2.0) * std::sqrt(2.5), 1e-12);  // ln 2 and -ln 4
  EXPECT_NEAR(errors.explained.value(), 1 - 2.5, 1e-12);  // variance (ln 2)^2: worse than the mean
  EXPECT_FALSE(errors_of({{"A", 0.1, 0.1, 0, 2.0}}, {3.0}).explained) << "no variance";
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

constexpr double radius = 0.065, plate_speed = 7.0;

TEST(Transition, MeetsTheEvenMotionOnTheArcWhereTheCrossingIsTangentToIt) {
  const auto even = FieldsAre(testing::DoubleEq(0.455), testing::DoubleEq(3.185));
  EXPECT_THAT(on_arc(radius, plate_speed), even);
  EXPECT_THAT(on_crossing(radius, plate_speed, 0), even);
}

/// With the parts of equation (4): normal r w^2 / cos(angle), and tangential the speed's slope.
TEST(Transition, GivesEquation5FromEquation4WithTheAngleReadAsNinetyDegreesMore) {
  for (double angle = -1.4; angle <= 1.4; angle += 0.05) {
    const double c = std::cos(angle);
    const double push = radius * plate_speed * plate_speed;
    const double normal = push / c;
    const double tangential = 2 * push * std::sin(angle) / (c * c * c);
    // a_tau = dV/dt with angle = omega t, by a central difference of equation (3).
    const double h = 1e-6;
    const double slope = (on_crossing(radius, plate_speed, angle + h).speed -
                          on_crossing(radius, plate_speed, angle - h).speed) /
                         (2 * h) * plate_speed;
    EXPECT_NEAR(tangential, slope, 1e-7 * (1 + std::abs(slope)));
    const auto composed = [&](double cosine) {
      return std::sqrt(normal * normal + tangential * tangential +
                       2 * normal * tangential * cosine);
    };
    const double a = on_crossing(radius, plate_speed, angle).acceleration;
    EXPECT_NEAR(composed(-std::sin(angle)), a, 1e-12 * a);
    if (std::abs(angle) > 0.1) {
      EXPECT_GT(std::abs(composed(c) - a), 1e-3 * a) << "the extraction's cosine";
    }
  }
}

TEST(Transition, MakesACrossingOfEveryHalfTurn) {
  const double angle = 0.5;
  const auto knots = crossing_profile(plate_speed, angle, 1.7);
  ASSERT_EQ(knots.size(), 20U);  // four half turns, five knots each
  for (std::size_t k = 0; k < knots.size(); ++k) {
    EXPECT_GT(knots[k].time, k > 0 ? knots[k - 1].time : 0.0);
    // Each knot lies on equation (3), over the plate's angle from the nearer tangent.
    const double half_turn = std::numbers::pi;
    const double from_middle =
        std::remainder(plate_speed * knots[k].time - half_turn / 2, half_turn);
    EXPECT_NEAR(knots[k].omega, on_crossing(1.0, plate_speed, angle - std::abs(from_middle)).speed,
                1e-9);
  }
  EXPECT_NEAR(knots.front().omega, plate_speed, 1e-12);
}

}  // namespace
}  // namespace ricochet::carrier_track::inline paper
