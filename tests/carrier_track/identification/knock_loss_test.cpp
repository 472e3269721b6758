#include "problems/carrier_track/identification/knock_loss.h"

#include "problems/carrier_track/identification/knock_problem.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

TEST(KnockUnknowns, ArePointsAndBack) {
  const Vector x = Vector::LinSpaced(knock_unknowns, -3, 2);
  EXPECT_LT((point_of(unknowns_at(x)) - x).norm(), 1e-14);
}

TEST(KnockUnknowns, HaveSlopesOfTheConstants) {
  const Vector x = point_of(guess_of(knocking_machine()));
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const auto constant = [&](double change) {
      const KnockUnknowns u = unknowns_at(x + change * Vector::Unit(x.size(), i));
      return i == 0 ? u.restitution : i == 1 ? u.friction : u.clearance;
    };
    EXPECT_NEAR(slopes_at(x)[i], (constant(1e-5) - constant(-1e-5)) / 2e-5, 1e-9);
  }
}

TEST(KnockUnknowns, BecomeConstantsOfAScene) {
  const KnockUnknowns u = guess_of(knocking_machine());
  const Scene other = with(knocking_machine(), set::walls(1, 2), set::restitution(0.1),
                           set::friction(0), set::start_position(2));
  const Scene scene = with_constants(other, u);
  EXPECT_EQ(std::tuple(scene.restitution_lower, scene.restitution_upper, scene.friction,
                       scene.wall_upper, scene.start_position),
            std::tuple(0.5, 0.5, 0.2, 1 + u.clearance, 1));
}

const KnockRecord ramp{{}, {{10, 3}, {25, 6}}, 10, 25, {}};

TEST(PredictedImpacts, AreThoseOfTheSimulation) {
  const Vector x = point_of(guess_of(knocking_machine()));
  const auto impacts = plain_impacts(knocking_machine(), ramp, x, 1e-3);
  // The same machine from rest, two turns before the record.
  const double settling = 4 * std::numbers::pi / 3;
  Scene scene = with(knocking_machine(), set::seconds(settling + 15));
  scene.phase -= 3 * settling;
  scene.profile = {{0, 3}, {settling, 3}, {settling + 15, 6}};
  std::vector<Impact> expected;
  for (const Impact& impact : simulate(scene).impacts) {
    if (impact.speed > 1e-3 && impact.time >= settling) expected.push_back(impact);
  }
  ASSERT_EQ(impacts.size(), expected.size());
  ASSERT_GT(impacts.size(), 30U);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    EXPECT_NEAR(impacts[i].time, expected[i].time - settling + 10, 1e-9);
    EXPECT_NEAR(impacts[i].log_speed, std::log(expected[i].speed), 1e-7);
  }
}

TEST(PredictedImpacts, ComeEarlierOnAFasterPlate) {
  const auto last = [](double speed_factor) {
    KnockUnknowns at = guess_of(knocking_machine());
    at.speed_factor = speed_factor;
    const KnockRecord record{{}, {{0, 4}}, 0, 20, {}};
    return plain_impacts(knocking_machine(), record, point_of(at), 1e-2).back().time;
  };
  EXPECT_NEAR(last(1.001) / last(1), 1 / 1.001, 1e-4);
}

const KnockUnknowns known{.restitution = 0.5,
                          .friction = 0.2,
                          .clearance = 1e-3,
                          .phase = 0,
                          .speed_factor = 1,
                          .jitter = 1e-3,
                          .recorded_share = 0.8,
                          .spurious_rate = 0.5,
                          .detection_limit = 5e-3,
                          .gain = 1,
                          .scatter = 0.1};

const KnockRecord silent{{}, {{0, 5}}, 0, 10, {}};

/// One strong impact, 1 s after the start; one exactly at the detection limit, half a second later.
KnockDensity density_of_two(const KnockRecord& record = silent, double blur = 0) {
  return {record, {{1.0, std::log(0.1)}, {1.5, std::log(5e-3)}}, point_of(known), blur};
}

double gaussian(double off, double width) {
  return std::exp(-off * off / (2 * width * width)) / (width * std::sqrt(2 * std::numbers::pi));
}

TEST(KnockDensity, IsAGaussianAroundEachImpactAboveASpuriousRate) {
  const double wide = std::hypot(1e-3, 0.01);  // by a blur of the plate's angle
  for (const auto& [blur, time, gaussians] : {std::tuple(0.0, 1.0, 0.8 * gaussian(0, 1e-3)),
                                              {0.0, 1.002, 0.8 * gaussian(0.002, 1e-3)},
                                              {0.0, 1.5, 0.4 * gaussian(0, 1e-3)},
                                              {0.0, 3.0, 0.0},
                                              {0.05, 1.01, 0.8 * gaussian(0.01, wide)}}) {
    EXPECT_NEAR(density_of_two(silent, blur).log_at({time}, nullptr), std::log(0.5 + gaussians),
                1e-9)
        << time;
  }
}

TEST(KnockDensity, ExpectsAsManyKnocksAsItIntegratesTo) {
  const KnockDensity density = density_of_two();
  EXPECT_NEAR(density.expected(nullptr), 5 + 0.8 + 0.4, 1e-12);
  double integral = 0;
  const double step = 1e-4;
  for (double t = step / 2; t < 10; t += step) {
    integral += step * std::exp(density.log_at({t}, nullptr));
  }
  EXPECT_NEAR(integral, density.expected(nullptr), 1e-6);
}

/// After a knock the sensor is deaf: the impact that it is of has been heard, and another, even one
/// that follows within a jitter or two, is not expected. Of two that may be it, one is.
TEST(KnockDensity, ExpectsNoOtherImpactInTheDeadTimeAfterAKnock) {
  KnockRecord record = silent;
  record.knocks = {{1.0}};
  record.dead_time = 0.02;
  const double spurious = 0.5 * (10 - record.dead_time);
  // Half of one at the same time is before the knock, where the sensor would have heard it.
  for (const auto& [later, impacts] :
       {std::pair{0.0, 1.5}, {0.003, 1.0}, {0.006, 1.0}, {0.015, 1.0}}) {
    const KnockDensity density(record, {{1.0, std::log(0.1)}, {1 + later, std::log(0.1)}},
                               point_of(known), 0);
    EXPECT_NEAR(density.expected(nullptr), spurious + 0.8 * impacts, 0.02) << later;
  }
}

TEST(KnockDensity, OfStrengthsIsPerLogarithmOfStrength) {
  KnockRecord record = silent;
  record.knocks = {{0.5, 0.01}, {2, 0.1}};  // the range of strengths: a factor of ten
  const KnockDensity density = density_of_two(record);
  for (const double off : {0.0, 0.2}) {
    EXPECT_NEAR(density.log_at({1.0, 0.1 * std::exp(off)}, nullptr),
                std::log(0.5 / std::log(10.0) + 0.8 * gaussian(0, 1e-3) * gaussian(off, 0.1)),
                1e-9);
  }
}

/// With one impact the information is known: its time counts as one Gaussian measurement in the
/// share of records in which it appears; that share has the variance of a yes or no.
TEST(KnockDensity, HasTheInformationOfIndependentImpacts) {
  KnockUnknowns at = known;
  at.spurious_rate = 1e-6;
  std::vector<PredictedImpact> impact = {{1.0, std::log(0.1)}};
  impact[0].time_slopes[2] = 3;
  const auto both = KnockDensity(silent, impact, point_of(at), 0).information();
  EXPECT_NEAR(both.information(2, 2), 0.8 * 9 / 1e-6, 0.01 * 0.8 * 9 / 1e-6);
  EXPECT_NEAR(both.score(2, 2), both.information(2, 2), 1e-6 * both.information(2, 2));
  EXPECT_NEAR(both.information(5, 5), 0.8 * 2, 0.02);  // of the logarithm of the jitter
  EXPECT_NEAR(both.information(6, 6), 0.8 * 0.2 * 0.2, 1e-3);
  EXPECT_NEAR(both.score(6, 6), 0.8 * 0.2 * 0.2 * 0.2, 1e-3);
}

void expect_exact_slopes(const KnockRecord& record, Vector x) {
  const KnockLoss loss(knocking_machine(), record);
  if (record.has_strengths()) x[8] = loss.guess()[8];
  if (record.plate) x.segment(3, 2) << record.plate->phase + 1e-3, record.plate->log_speed;
  x[2] += 0.02;
  for (const double blur : {0.0, 0.02}) {
    Vector slopes;
    loss.at(x, blur, &slopes);
    for (const Eigen::Index i : loss.free()) {
      const double step = i == coordinate::speed_factor || i == coordinate::drift ? 1e-9
                          : i == coordinate::lag                                  ? 1e-8
                                                                                  : 1e-6;
      const Vector change = step * Vector::Unit(x.size(), i);
      const double expected = (loss.at(x + change, blur) - loss.at(x - change, blur)) / (2 * step);
      EXPECT_NEAR(slopes[i], expected, 1e-4 * (1 + std::abs(expected))) << "coordinate " << i;
    }
  }
}

TEST(KnockLoss, HasExactSlopes) {
  for (const KnockRecord& record :
       {example_record(), example_record({.strengths = true, .mark_jitter = 1e-3})}) {
    expect_exact_slopes(record, example_point(record));
  }
}

/// Lag, drift, a deaf sensor, a wall each, saturated strengths.
TEST(KnockLoss, HasExactSlopesOfEachFaultOfAMeasurement) {
  for (const bool strengths : {false, true}) {
    const SensorModel sensor{.strengths = strengths,
                             .mark_jitter = 1e-3,
                             .lag = 2e-3,
                             .drift = 1e-4,
                             .dead_time = 12e-3,
                             .saturation = 0.06};
    KnockRecord record = example_record(sensor);
    record.lag_deviation = 5e-3;
    record.dead_time = sensor.dead_time;
    if (strengths) record.saturation = sensor.saturation;
    Vector x = example_point(record);
    x.tail(3) << 1, 1.5e-3, 5e-5;  // the upper wall's share, lag, drift
    expect_exact_slopes(record, x);
  }
}

TEST(KnockLoss, FitsWhatTheSensorTells) {
  const KnockRecord times = example_record(), strengths = example_record({.strengths = true});
  EXPECT_THAT(KnockLoss(knocking_machine(), times).free(), AllOf(Contains(8), Not(Contains(9))));
  EXPECT_THAT(KnockLoss(knocking_machine(), strengths).free(),
              AllOf(Contains(9), Not(Contains(8))));
}

/// The mean of the slopes over records is zero at the truth, and their covariance that of the
/// scores: what the intervals rest on.
TEST(KnockLoss, HasScoresOfTheExpectedSpread) {
  constexpr int records = 60;
  const Vector x = example_point(example_record());
  Vector sum = Vector::Zero(knock_unknowns), squares = sum, variance;
  for (int k = 0; k < records; ++k) {
    const KnockRecord record = example_record({}, static_cast<std::uint64_t>(k) + 1);
    const KnockLoss loss(knocking_machine(), record);
    Vector slopes;
    loss.at(x, 0, &slopes);
    sum += slopes;
    squares += slopes.cwiseProduct(slopes);
    if (k == 0) variance = loss.information(x).score.diagonal();
  }
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(sum[i]) / records, 3.5 * std::sqrt(variance[i] / records)) << i;
    EXPECT_NEAR(squares[i] / records / variance[i], 1, 0.7) << i;
  }
}

TEST(KnockProblem, HasTheLossOfItsCoordinatesScaledByTheInformation) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const Vector centre = example_point(record);
  const KnockCoordinates coordinates = knock_coordinates(loss, centre, 0, loss.free());
  const Problem problem = knock_problem(loss, coordinates, 0);
  ASSERT_EQ(problem.dimension(), 10);
  EXPECT_EQ(problem.evaluate(problem.start).objective, loss.at(centre, 0));
  const Vector z = Vector::Constant(10, 0.1);
  EXPECT_EQ(problem.evaluate(z).objective, loss.at(coordinates.at(z), 0));
  Vector slopes;
  loss.at(coordinates.at(z), 0, &slopes);
  EXPECT_LT(
      (problem.differentiate(z).gradient - coordinates.directions.transpose() * slopes).norm(),
      1e-10 * slopes.norm());
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

TEST(NextSpeed, PredictsWhatALongerRecordWouldKnow) {
  const KnockRecord record = example_record();
  const Vector x = example_point(record);
  const auto deviation_of_friction = [&](const KnockRecord& known_record) {
    const KnockLoss loss(knocking_machine(), known_record);
    return std::sqrt(covariance_of(loss.information(x), loss.free())(1, 1));
  };
  const auto next =
      next_speed(KnockLoss(knocking_machine(), record), x, Vector::Unit(machine_constants, 1), 18);
  ASSERT_TRUE(next);
  EXPECT_LT(next->deviation, next->now);
  EXPECT_NEAR(next->now, deviation_of_friction(record), 1e-12);
  // If the record goes on for a step of a speed.
  const auto deviation_with = [&](double omega) {
    KnockRecord longer = record;
    longer.speed.push_back({record.to + 1e-3, omega});
    longer.to = record.to + next_step_seconds;
    return deviation_of_friction(longer);
  };
  EXPECT_NEAR(deviation_with(next->omega) / next->deviation, 1, 0.1);
  for (const double other : {0.7, 1.5}) {
    EXPECT_GT(deviation_with(other * next->omega), 0.95 * next->deviation);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
