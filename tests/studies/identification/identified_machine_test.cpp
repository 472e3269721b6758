#include "src/identification/identified_machine.h"

#include "problems/carrier_track/identification/knock_problem.h"
#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/identification/knock_fit.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"
#include "tests/carrier_track/regimes/machines.h"
#include "tests/support/test.h"

namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;

TEST(FitStarts, FindThePlatesAngleUpToHalfATurnAndItsSpeed) {
  Random random(3);
  KnockRecord record =
      synthetic_knocks(with(knocking_machine(), set::phase(2)), {{0, 3}, {30, 6}}, {}, random);
  for (SpeedKnot<double>& knot : record.speed) knot.omega /= 1.007;
  const auto starts = fit_starts(KnockLoss(knocking_machine(), record), 3, random);
  ASSERT_EQ(starts.size(), 3U);
  EXPECT_NEAR(std::exp(starts[0][4]), 1.007, 1e-3);
  EXPECT_NEAR(std::remainder(starts[0][3] - 2, std::numbers::pi), 0, 0.3);
}

TEST(FitStarts, KeepWhatMarksSay) {
  Random random(3);
  const KnockRecord record = example_record({.mark_jitter = 1e-3});
  const auto starts = fit_starts(KnockLoss(knocking_machine(), record), 3, random);
  ASSERT_FALSE(starts.empty());
  for (const Vector& start : starts) {
    EXPECT_EQ(start[3], record.plate->phase);
    EXPECT_NEAR(start[4], record.plate->log_speed, 1e-12);
  }
}

/// An elastic carrier would knock without end.
TEST(FitStarts, AreWithinTheLimitsOfASearch) {
  Random random(3);
  const KnockRecord record = example_record();
  const KnockLoss loss(with(knocking_machine(), set::restitution(1 - 1e-6)), record);
  EXPECT_GT(unknowns_at(loss.guess()).restitution, 0.985);
  const std::vector<Vector> starts = fit_starts(loss, 40, random);
  ASSERT_FALSE(starts.empty());
  for (const Vector& start : starts) {
    EXPECT_EQ(start, within_limits(start));
    EXPECT_LT(unknowns_at(start).restitution, 0.983);
  }
}

/// A guess that is far from the truth.
Scene wrong_machine() {
  return with(knocking_machine(), set::restitution(0.4), set::friction(0.22),
              set::wall_upper(0.9e-3));
}

TEST(KnockFit, FindsTheTruthFromMarksAndStrengths) {
  const KnockRecord record = example_record({.strengths = true, .mark_jitter = 1e-3});
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

/// The record in which a neighbouring minimum, 10 % off in the friction, once was taken for the
/// best.
TEST(KnockFit, FindsTheTruthBesideANeighbouringMinimum) {
  Random random(10);
  const Scene truth = with(knocking_machine(), set::phase(2 * std::numbers::pi * uniform(random)));
  const KnockRecord record = synthetic_knocks(truth, six_speeds(), {.mark_jitter = 1e-3}, random);
  const KnockLoss loss(guess_near(truth, random), record);
  const KnockFit fit = fit_knocks(loss, solver_named(usual_solver));
  EXPECT_NEAR(fit.x[coordinate::friction], std::log(truth.friction), 0.02);
}

TEST(KnockFit, IsTheSameByAnotherSolver) {
  const KnockRecord record = example_record({.mark_jitter = 1e-3}, 5);
  const KnockLoss loss(wrong_machine(), record);
  EXPECT_NEAR(fit_knocks(loss, solver_named(usual_solver)).loss,
              fit_knocks(loss, solver_named("nlopt-lbfgs")).loss, 0.05);
}

/// Without loss, and pulled as hard as it is thrown, the impacts of a minute depend on the
/// constants by more than a number can hold.
TEST(KnockFit, IsRefusedWhereImpactsDependOnTheConstantsWithoutLimit) {
  const Scene elastic =
      with(strange_machine(90), set::fidelity(Fidelity::impact), set::rule(CountRule::impacts),
           set::disturbance(0), set::restitution(1));
  Random random(90);
  const KnockRecord record = synthetic_knocks(elastic, {{0, 4.6}, {60, 16.3}}, {}, random);
  const KnockLoss loss(elastic, record);
  EXPECT_THROW(fit_knocks(loss, solver_named(usual_solver)), InputError);
}

TEST(KnockCharts, ShowEveryKnockAndEveryPredictedImpact) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const auto charts = knock_charts(loss, example_point(record));
  ASSERT_EQ(charts.size(), 2U);
  for (const report::Chart& chart : charts) report::check(chart);
  std::size_t knocks = 0;
  for (const report::Series& series : charts[0].series) knocks += series.samples.size();
  EXPECT_EQ(knocks, record.knocks.size());
  EXPECT_EQ(charts[1].series[1].samples.size(), record.knocks.size());
  // Most knocks are within three standard deviations of the prediction, 1 ms.
  const auto is_near = [](const report::Sample& sample) { return std::abs(*sample.value) < 3; };
  EXPECT_GT(std::ranges::count_if(charts[0].series[0].samples, is_near),
            0.85 * static_cast<double>(knocks));
}

IdentifiedMachine identified(const KnockRecord& record) {
  return identify(KnockLoss(knocking_machine(), record), solver_named(usual_solver), 18);
}

TEST(IdentifiedMachine, HasIntervalsOfConstantsAndSafeSpeed) {
  const IdentifiedMachine machine =
      identified(example_record({.strengths = true, .mark_jitter = 1e-3}));
  ASSERT_EQ(machine.constants.size(), 3U);
  for (const Estimate& e : machine.constants) {
    EXPECT_LT(e.lower, e.value);
    EXPECT_LT(e.value, e.upper);
  }
  EXPECT_EQ(machine.constants[1].assumed, 0.2);
  EXPECT_EQ(machine.scene.friction, machine.constants[1].value);
  ASSERT_TRUE(machine.safe_speed);
  EXPECT_NEAR(machine.safe_speed->value / *safe_speed(machine.scene), 1, 1e-9);
  EXPECT_LT(machine.safe_speed->upper / machine.safe_speed->lower, 1.1);
  ASSERT_TRUE(machine.next);
  EXPECT_EQ(machine.next_target, "safe speed");
  EXPECT_NEAR(machine.missed_share, 0.05, 0.12);  // each wall has few knocks
  EXPECT_NEAR(machine.explained_share, 0.95, 0.06);
}

TEST(IdentifiedMachine, SaysWhatOneSpeedCannotTell) {
  Random random(1);
  const KnockRecord record = synthetic_knocks(knocking_machine(), {{0, 3}, {30, 3}}, {}, random);
  EXPECT_THAT(identified(record).remarks, Contains(HasSubstr("does not determine the clearance")));
}

TEST(IdentifiedMachine, SaysThatItDoesNotExplainARecord) {
  KnockRecord record = example_record();
  Random random(1);
  for (Knock& knock : record.knocks) knock.time = 15 * uniform(random);
  std::ranges::sort(record.knocks, {}, &Knock::time);
  EXPECT_THAT(identified(record).contradictions, Contains(HasSubstr("explains only")));
}

/// A minute from 2 to 15 rad/s.
KnockRecord measured(const SensorModel& sensor, double mark_error) {
  Random random(7);
  return measured_knocks(knocking_machine(), {{0, 2}, {60, 15}}, sensor, mark_error, random);
}

TEST(IdentifiedMachine, IsFoundThroughFaultsOfTheMeasurement) {
  int fault = 0;
  for (const auto& [sensor, mark_error] : std::vector<std::pair<SensorModel, double>>{
           {{.strengths = true}, 0.02},
           {{.strengths = true}, -0.05},
           {{.strengths = true, .lag = 2e-3}, 0},
           {{.strengths = true, .lag = -5e-3}, 0},
           {{.strengths = true, .drift = 1e-4}, 0},
           {{.strengths = true, .echo_delay = 4e-3}, 0},
           {{.strengths = true, .dead_time = 10e-3}, 0},
           {{.strengths = true, .upper_gain = 0.01}, 0},
           {{.strengths = true, .saturation = 0.06}, 0},
       }) {
    SCOPED_TRACE(testing::Message() << "fault " << fault++);
    const IdentifiedMachine machine = identified(measured(sensor, mark_error));
    EXPECT_THAT(machine.contradictions, IsEmpty());
    const double truths[] = {0.5, 0.2, 0.7e-3};
    for (std::size_t i = 0; i < 3; ++i) {
      const Estimate& e = machine.constants[i];
      EXPECT_LT(std::abs(std::log(e.value / truths[i]) / std::log(e.upper / e.lower)), 0.8)
          << e.name;
    }
  }
}

TEST(IdentifiedMachine, SaysWhatARecordContradicts) {
  KnockRecord late = measured({.strengths = true, .lag = 3e-3}, 0);
  late.lag_deviation = 0;
  EXPECT_THAT(identified(late).contradictions, Contains(HasSubstr("one clock")));
  KnockRecord turned = measured({.strengths = true}, 0);
  Random random(1);
  turned.lag_deviation = 0;
  turned.plate =
      plate_measurement(turned, mark_times(knocking_machine(), turned, 1e-3, random), 0.03, 0);
  EXPECT_THAT(identified(turned).contradictions, Contains(HasSubstr("the marks' angle")));
}

}  // namespace
}  // namespace ricochet::studies::identification
