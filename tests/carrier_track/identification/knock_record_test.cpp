#include "problems/carrier_track/identification/knock_record.h"

#include <Eigen/LU>

#include "ricochet/machine.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

TEST(KnockRecord, InterpolatesAndIntegratesSpeedsAndHoldsThemOutside) {
  const std::vector<SpeedKnot<double>> up_and_on = {{1, 2}, {3, 6}};
  for (const auto& [time, speed] : {std::pair(0, 2), {2, 4}, {9, 6}}) {
    EXPECT_EQ(speed_at(up_and_on, time), speed);
  }
  for (const auto& [from, to, angle] : {std::tuple(0.0, 1.0, 2), {0.0, 5.0, 22}, {1.5, 2.5, 4}}) {
    EXPECT_NEAR(angle_between(up_and_on, from, to), angle, 1e-14);
  }
}

/// Of marks of a plate whose speed is 1 % above the recorded 2 rad/s; alpha is 0.3 rad at 0 s. One
/// mark is missed.
PlateMeasurement plate_by_marks(double error, double mark_angle = 0) {
  std::vector<double> marks;
  for (const int k : {1, 2, 3, 4, 6, 7, 8, 9, 10, 11}) {
    marks.push_back((2 * pi * k - 0.3) / 2.02 + (k % 2 == 0 ? error : -error));
  }
  return plate_measurement({{}, {{0, 2}}, 0, 40, {}}, marks, mark_angle);
}

void expect_angle(double angle, double expected, double tolerance = 1e-9) {
  EXPECT_NEAR(std::remainder(angle - expected, 2 * pi), 0, tolerance);
}

TEST(KnockRecord, FindsPhaseAndSpeedFromMarksAsWellAsTheyAgree) {
  EXPECT_NEAR(std::exp(plate_by_marks(0).log_speed), 1.01, 1e-12);
  for (const double mark_angle : {0.0, 0.5}) {
    expect_angle(plate_by_marks(0, mark_angle).phase, 0.3 + mark_angle);
  }
  const PlateMeasurement fine = plate_by_marks(1e-3), coarse = plate_by_marks(2e-3);
  EXPECT_NEAR(fine.deviation, 2.02e-3, 0.3e-3);
  EXPECT_NEAR(fine.information(0, 0) / coarse.information(0, 0), 4, 1e-3);
  EXPECT_NEAR(fine.information(0, 0), 10 / std::pow(fine.deviation, 2), 1e-3);
}

/// Marks on a ramp that lag the speeds by 3 ms shift neither phase nor speed, if lags are allowed
/// for; the phase is known no better than the angle at a mark.
TEST(KnockRecord, AllowsForALagAndAnUncertainAngleOfMarks) {
  KnockRecord record{{}, {{0, 2}, {40, 12}}, 0, 40, {}};
  std::vector<double> marks;
  for (int k = 1; k < 40; ++k) {
    const double angle = 2 * pi * k - 0.3;
    marks.push_back(-8 + std::sqrt(64 + 8 * angle) + 3e-3 + (k % 2 == 0 ? 1e-4 : -1e-4));
  }
  const PlateMeasurement exact = plate_measurement(record, marks, 0);
  record.lag_deviation = 5e-3;
  const PlateMeasurement lagging = plate_measurement(record, marks, 0, 0.05);
  expect_angle(lagging.phase, 0.3, 1e-3);
  EXPECT_NEAR(lagging.log_speed, 0, 1e-5);
  EXPECT_GT(std::abs(exact.log_speed), 1e-5);
  EXPECT_NEAR(lagging.information.inverse()(0, 0), 0.05 * 0.05, 0.05 * 0.05 * 0.01);
  EXPECT_LT(lagging.deviation, 2e-3);
}

/// Files with 30 knocks, a second apart.
class KnockFile : public TemporaryFolder {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    return write_file(folder_ / name, text).string();
  }
  std::string knocks(const std::string& header, const std::string& more) const {
    std::string text = header + "\n";
    for (int i = 0; i < 30; ++i) text += fmt::format("{}.5{}\n", i, more);
    return write("knocks.csv", text);
  }
  std::string speed(double omega, double from = 0) const {
    return write("speed.csv",
                 fmt::format("time,omega\n{},{}\n{},{}\n", from, omega, from + 30, omega));
  }
  /// Of a plate at 4 rad/s.
  std::string marks(double from) const {
    std::string text = "time\n";
    for (int k = 1; k < 19; ++k) text += fmt::format("{}\n", from + k * 1.5708);
    return write("marks.csv", text);
  }
};

std::string complaint_about_record(const KnockFiles& files) {
  return complaint_of([&] { read_knock_record(files); });
}

TEST_F(KnockFile, IsARecordAndMayHoldTheSpeedOrNeedNone) {
  const auto expect_range = [](const KnockRecord& record, double from, double to, double speed) {
    EXPECT_EQ(std::tuple(record.from, record.to, speed_at(record.speed, 20)),
              std::tuple(from, to, speed));
  };
  const KnockRecord record = read_knock_record(
      {knocks("time,strength", ",2"), {}, write("speed.csv", "time,omega\n0,3\n40,5\n"), ""});
  EXPECT_EQ(record.knocks.size(), 30U);
  EXPECT_THAT(record.knocks[2], FieldsAre(2.5, 2));
  EXPECT_FALSE(record.plate);
  expect_range(record, 0, 40, 4);
  expect_range(read_knock_record({knocks("time,omega", ",3"), {}, "", ""}), 0.5, 29.5, 3);
  expect_range(read_knock_record({knocks("time", ""), 4, "", ""}), 0.5, 29.5, 4);
}

TEST_F(KnockFile, MayComeWithMarks) {
  const KnockRecord record = read_knock_record(
      {knocks("time", ""), 3.14159265, "", write("m.csv", "time\n1.5\n3.5\n5.5\n")});
  ASSERT_TRUE(record.plate);
  // A mark passes a second, half a turn, later.
  EXPECT_NEAR(record.plate->phase, -3.14159265, 1e-6);
}

TEST_F(KnockFile, IsRefusedWithItsPlace) {
  const std::string good = knocks("time", ""), few = write("few.csv", "time\n1\n2\n");
  expect_refusals<InputError, KnockFiles>(
      read_knock_record, {{{good, {}, "", ""}, "one of --omega, --speed"},
                          {{good, 0.1, "", ""}, "turns"},
                          {{good, -1, "", ""}, "--omega -1"},
                          {{good, 4, "speed.csv", ""}, "only one of"},
                          {{good, 4, "", few}, "three marks"},
                          {{few, 4, "", ""}, "2 knocks: must have at least 20"},
                          {{good, 4, "", "", 0, usual_mark_deviation, 1}, "--lag-deviation 1"},
                          {{good, 4, "", "", 0, -1}, "--mark-deviation -1"},
                          {{write("back.csv", "time\n2\n1\n"), 4, "", ""},
                           "back.csv:3: column time: 1: must be no earlier"}});
  EXPECT_THAT(complaint_about_record({knocks("time,strength", ",0"), 4, "", ""}),
              HasSubstr("knocks.csv:2: column strength: 0: must be > 0"));
  EXPECT_THAT(complaint_about_record({knocks("time,omega", ",-1"), {}, "", ""}),
              HasSubstr("knocks.csv:2: column omega: -1"));
}

/// Speeds in another unit, clocks apart: doubted before anything is fitted.
TEST_F(KnockFile, IsDoubtedIfFilesContradictEachOther) {
  const std::string heard = knocks("time", ""), unmarked, marked = marks(0);
  for (const auto& [marks_file, omega, message] :
       {std::tuple(unmarked, 4.0, "accepted"),
        {unmarked, 38.2, "0.17 a turn: must be at least 1"},
        {unmarked, 229.0, "a turn: must be at least 1"},
        {marked, 4.0, "accepted"},
        {marked, 4.3, "accepted"},
        {marked, 38.2, "in rpm"},
        {marked, 229.0, "in degrees per second"},
        {marked, 0.6366, "in turns per second"},
        {marked, 2.0, "two marks"},
        {marked, 5.0, "1.25 turns"}}) {
    EXPECT_THAT(complaint_about_record({heard, {}, speed(omega), marks_file}), HasSubstr(message))
        << omega;
  }
  for (const double apart : {16.0, 100.0, -1e4}) {
    EXPECT_THAT(complaint_about_record({heard, {}, speed(4, apart), ""}),
                HasSubstr("do the clocks differ?"));
    EXPECT_THAT(complaint_about_record({heard, {}, speed(4), marks(apart)}),
                HasSubstr("do the clocks differ?"));
  }
}

TEST(KnockFiles, OfOtherMachinesSayNothing) {
  const Scene scene = knocking_machine();
  EXPECT_NO_THROW(check_identifiable(scene, "m.toml"));
  expect_refusals<InputError, Scene>(
      [](const Scene& each) { check_identifiable(each, "m.toml"); },
      {{with(scene, set::fidelity(Fidelity::compliant)), "m.toml: model.fidelity"},
       {with(scene, set::restitution_lower(0.4)), "restitution"},
       {with(scene, set::friction(0)), "friction"},
       {with(scene, set::disturbance(1)), "disturbance"},
       {with(scene, set::centrifugal_mass_radius(0)), "centrifugal"},
       {with(scene, set::wall_upper(infinity)), "wall_upper"}});
}

/// Collisions per turn in steady motion, by a long window that begins after the start's decay.
double per_turn(const Scene& scene, double omega) {
  const auto count_in = [&](double turns) {
    return counts(with(scene, set::start(0.3e-3, 0), set::revolutions(turns)),
                  std::vector<double>{omega})
        .front();
  };
  return (count_in(40) - count_in(20)) / 20.0;
}

TEST(SafeSpeed, IsTheLastWithTwoCollisionsATurn) {
  const std::optional<double> safe = safe_speed(knocking_machine());
  ASSERT_TRUE(safe);
  EXPECT_EQ(per_turn(knocking_machine(), 0.9999 * *safe), 2);
  EXPECT_GT(per_turn(knocking_machine(), 1.0001 * *safe), 2);
}

TEST(SafeSpeed, IsMissingWhereEverySpeedOrNoneIsSafe) {
  EXPECT_FALSE(safe_speed(with(knocking_machine(), set::restitution(0)), 10));
  const Scene loud = with(knocking_machine(), set::friction(0), set::pull(0), set::restitution(0.9),
                          set::counting_limit(1e-6));
  EXPECT_GT(per_turn(loud, 0.05), 2);
  EXPECT_FALSE(safe_speed(loud, 10));
}

KnockRecord without_faults(KnockRecord record) {
  take_out_sensor_faults(record);
  return record;
}

/// Echoes of several delays and ratios, with strengths and without, at most 7 % of the
/// knocks away from what the sensor records without echoes.
TEST(SensorFaults, EchoesAreLeftOut) {
  for (const bool strengths : {false, true}) {
    const auto clean =
        static_cast<double>(without_faults(example_record({.strengths = strengths})).knocks.size());
    for (const double delay : {1.5e-3, 4e-3, 9e-3, 25e-3}) {
      for (const double ratio : {0.3, 0.6}) {
        SCOPED_TRACE(fmt::format("{} {} {}", delay, ratio, strengths));
        const KnockRecord record = without_faults(
            example_record({.strengths = strengths, .echo_delay = delay, .echo_ratio = ratio}));
        EXPECT_NEAR(static_cast<double>(record.knocks.size()) / clean, 1, 0.07);
        ASSERT_FALSE(record.notes.empty());
        EXPECT_THAT(record.notes[0], HasSubstr("echoes"));
      }
    }
  }
}

TEST(SensorFaults, ReboundsAreNoEchoes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const double jitter : {1e-5, 1e-3}) {
      const KnockRecord record = example_record({.jitter = jitter}, seed);
      EXPECT_EQ(without_faults(record).knocks.size(), record.knocks.size()) << seed;
    }
  }
  Random random(1);
  const KnockRecord steady =
      synthetic_knocks(knocking_machine(), {{0, 4}, {30, 4}}, {.jitter = 1e-5}, random);
  const KnockRecord left = without_faults(steady);
  EXPECT_EQ(left.knocks.size(), steady.knocks.size());
  ASSERT_FALSE(left.notes.empty());
  EXPECT_THAT(left.notes[0], HasSubstr("taken for rebounds"));
}

/// Here the pairs of knocks within the longest delay would take gigabytes.
TEST(SensorFaults, EchoesAreNotLookedForInARecordThatIsTooDense) {
  KnockRecord record{{}, {{0, 4}}, 0, 10};
  for (int k = 0; k < 1'000'000; ++k) record.knocks.push_back({1e-5 * k});
  take_out_sensor_faults(record);
  EXPECT_EQ(record.knocks.size(), 1'000'000U);
  EXPECT_TRUE(record.notes.empty());
}

TEST(SensorFaults, OfRowsAtOneTimeTheStrongestStays) {
  const KnockRecord record =
      without_faults({{{1, 0.1}, {1, 0.3}, {1, 0.2}, {2, 0.1}}, {{0, 3}}, 0, 3, {}});
  EXPECT_THAT(record.knocks, ElementsAre(FieldsAre(1, 0.3), FieldsAre(2, 0.1)));
  EXPECT_THAT(record.notes, ElementsAre(HasSubstr("2 rows")));
  EXPECT_EQ(record.dead_time, 0.05);
}

TEST(SensorFaults, DeadTimeAndSaturationAreFound) {
  const KnockRecord record =
      without_faults(example_record({.strengths = true, .dead_time = 15e-3, .saturation = 0.05}));
  EXPECT_THAT(record.dead_time, AllOf(testing::Ge(15e-3), testing::Le(50e-3)));
  EXPECT_EQ(record.saturation, 0.05);
  EXPECT_EQ(without_faults(example_record()).saturation, infinity);
}

TEST(SyntheticKnocks, AreMissedAndAdded) {
  Random random(1);
  const auto knocks = [&](double missed, double spurious) {
    const SensorModel sensor{.missed_share = missed, .spurious_share = spurious, .scatter = 0};
    return static_cast<double>(
        synthetic_knocks(knocking_machine(), {{0, 4}, {300, 4}}, sensor, random).knocks.size());
  };
  const double all = knocks(0, 0);
  EXPECT_GT(all, 700);
  EXPECT_NEAR(knocks(0.3, 0), 0.7 * all, 0.06 * all);
  EXPECT_NEAR(knocks(0, 0.3), 1.3 * all, 0.06 * all);
}

}  // namespace
}  // namespace ricochet::carrier_track
