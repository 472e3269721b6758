#include "problems/carrier_track/counting/staircase.h"

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::_;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::IsEmpty;

/// The staircase up to `fastest` of a count that is known at every speed.
Staircase staircase_to(double fastest, const CountAt& count) {
  return staircase_of(scan_logarithmically(count, 0.01, judged_share * fastest), fastest);
}

TEST(Staircase, CountsAtTheSameSpeedsWhereverItEnds) {
  const auto count = [](double omega) { return static_cast<int>(100 * omega); };
  const LogarithmicScan shorter = scan_logarithmically(count, 0.01, 5);
  const LogarithmicScan longer = scan_logarithmically(count, 0.01, 50);
  EXPECT_EQ(shorter.first, longer.first);
  ASSERT_LT(shorter.counts.size(), longer.counts.size());
  for (std::size_t k = 0; k < shorter.counts.size(); ++k) {
    EXPECT_EQ(shorter.omega(k), longer.omega(k));
    EXPECT_EQ(shorter.counts[k], longer.counts[k]);
  }
  EXPECT_GE(shorter.omega(0), 0.01);
  EXPECT_LE(shorter.omega(shorter.counts.size() - 1), 5);
  EXPECT_NEAR(std::log(shorter.omega(500) / shorter.omega(0)), 1, 1e-12);
}

TEST(Staircase, FindsOneStepWhereItIs) {
  const Staircase staircase = staircase_to(18, [](double w) { return w < 5 ? 4 : 9; });
  ASSERT_EQ(staircase.steps.size(), 1U);
  const Step& step = staircase.steps.front();
  EXPECT_NEAR(step.omega, 5, 5 * 0.001);
  EXPECT_EQ(step.below, 4);
  EXPECT_EQ(step.above, 9);
  EXPECT_EQ(step.reach, 2);
  EXPECT_EQ(step.misclassified, 0);
  EXPECT_NEAR(step.significance, std::log(10.0 / 5.0) * std::log(2.0), 1e-12);
  ASSERT_EQ(staircase.levels.size(), 2U);
  EXPECT_EQ(staircase.levels[0].typical, 4);
  EXPECT_EQ(staircase.levels[1].typical, 9);
}

TEST(Staircase, HasNoStepWhereTheCountIsOfOneKind) {
  const auto steps_of = [](int below, int above) {
    return staircase_to(18, [=](double w) { return w < 3 ? below : above; }).steps;
  };
  EXPECT_THAT(steps_of(7, 7), IsEmpty());
  EXPECT_THAT(steps_of(0, 0), IsEmpty());
  // One collision more or less is the same kind, and so is less than half as many again.
  EXPECT_THAT(steps_of(1, 2), IsEmpty());
  EXPECT_THAT(steps_of(11, 14), IsEmpty());
  EXPECT_EQ(steps_of(0, 2).size(), 1U);
}

TEST(Staircase, HasNoThresholdWhereTheCountRisesThroughout) {
  for (const double power : {0.5, 1.0, 2.0}) {
    const auto rising = [power](double w) { return static_cast<int>(50 * std::pow(w, power)); };
    for (const Step& step : staircase_to(18, rising).steps) {
      EXPECT_LT(step.omega, 1) << "counts of a few have steps of their own; power " << power;
    }
  }
}

TEST(Staircase, HasNoStepInNoise) {
  Random random(3);
  LogarithmicScan scan = scan_logarithmically([](double) { return 0; }, 0.01, judged_share * 18);
  for (int repeat = 0; repeat < 20; ++repeat) {
    for (int& count : scan.counts) count = static_cast<int>(20 * uniform(random));
    EXPECT_TRUE(staircase_of(scan, 18).steps.empty());
  }
}

TEST(Staircase, FindsAStepThatSomeSpeedsDoNotTake) {
  Random random(5);
  std::vector<bool> odd(100'000);
  for (std::size_t k = 0; k < odd.size(); ++k) odd[k] = uniform(random) < 0.06;
  const auto count = [&](double w) {
    return (w < 6) != odd[static_cast<std::size_t>(w * 1000)] ? 3 : 12;
  };
  const auto main = staircase_to(18, count).main_step();
  ASSERT_TRUE(main);
  EXPECT_NEAR(main->omega, 6, 6 * 0.01);
  EXPECT_NEAR(main->misclassified, 0.06, 0.02);
}

TEST(Staircase, IsTheSameInOtherUnits) {
  const auto count = [](double w) { return w < 2 ? 3 : w < 7 ? 8 : 13; };
  const Staircase slow = staircase_to(18, count);
  const Staircase fast = staircase_to(180, [&](double w) { return count(w / 10); });
  ASSERT_EQ(slow.steps.size(), 2U);
  ASSERT_EQ(fast.steps.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(fast.steps[i].omega, 10 * slow.steps[i].omega, 0.02 * slow.steps[i].omega);
    EXPECT_EQ(fast.steps[i].significance, slow.steps[i].significance);
  }
}

/// The staircase of the part of a scan that one up to `fastest` would be.
Staircase part_of(const LogarithmicScan& whole, double fastest) {
  LogarithmicScan part = whole;
  while (part.omega(part.counts.size() - 1) > judged_share * fastest) part.counts.pop_back();
  return staircase_of(part, fastest);
}

/// Where a scan ends must not matter for a step within it.
void expect_the_same_steps(const Staircase& near, double fastest, const Staircase& far) {
  std::size_t within = 0;
  for (const Step& step : far.steps) within += step.omega <= fastest ? 1 : 0;
  ASSERT_EQ(near.steps.size(), within) << "to " << fastest;
  for (std::size_t i = 0; i < within; ++i) {
    EXPECT_EQ(near.steps[i].omega, far.steps[i].omega) << "to " << fastest;
    EXPECT_EQ(near.steps[i].significance, far.steps[i].significance) << "to " << fastest;
  }
}

/// The cases and drawn machines, 200 together: constants up to e times larger or smaller.
std::vector<Scene> many_machines() {
  Random random(7);
  std::vector<Scene> machines;
  for (const Case& a_case : all_cases()) {
    machines.push_back(case_scene(a_case.id));
  }
  for (std::size_t drawn = 0; machines.size() < 200; ++drawn) {
    Scene machine = machines[drawn % all_cases().size()];
    for (const std::string& key : constants_of(machine)) {
      machine = scaled(machine, key, std::exp(2 * uniform(random) - 1));
    }
    machines.push_back(machine);
  }
  return machines;
}

TEST(Staircase, DoesNotHangOnWhereTheScanEnds) {
  constexpr double farthest = 60;
  int same = 0, none = 0, beyond = 0;  // what becomes of the answer where a scan goes further
  for (const Scene& machine : many_machines()) {
    const LogarithmicScan whole =
        scan_logarithmically(machine, slowest_scanned, judged_share * farthest);
    const Staircase far = staircase_of(whole, farthest);
    const auto answer = far.main_step();
    for (const double fastest : {3.0, 7.0}) {
      expect_the_same_steps(part_of(whole, fastest), fastest, far);
    }
    bool moves = false;
    for (const double fastest : {14.0, 18.0, 30.0}) {
      const Staircase near = part_of(whole, fastest);
      expect_the_same_steps(near, fastest, far);
      const auto here = near.main_step();
      if (here ? here->omega == answer->omega : !answer) continue;
      moves = true;
      EXPECT_GT(answer->omega, fastest) << "nothing but a step beyond the end changes the answer";
    }
    ++(moves ? beyond : answer ? same : none);
  }
  EXPECT_EQ(same + none + beyond, 200);
  EXPECT_GT(same, 100);
  EXPECT_LT(beyond, 20);
}

/// A staircase that is known at every speed, scanned to 18 rad/s.
SpeedScan known_staircase(const std::function<double(double omega)>& count) {
  SpeedScan scan{0.01, {}};
  for (int k = 1; k <= 1800; ++k) {
    scan.counts.push_back(static_cast<int>(std::floor(count(0.01 * k) + 1e-9)));
  }
  return scan;
}

/// threshold, before, after, width, persistence and rise
TEST(StepSharpness, OfOneJumpIsAStepWithoutWidth) {
  const auto jump = known_staircase([](double w) { return w < 9 ? 5 : 8; });
  EXPECT_THAT(step_sharpness(jump, 8.995, 7.5).value(), FieldsAre(8.995, 5, 8, 0, 1, Rise::step));
}

TEST(StepSharpness, OfARampIsTheClimbBetweenTheMiddlesOfItsStretches) {
  // The count 10 w, more than 20 from 2.1 rad/s on: medians at 1.75 and 2.62 rad/s. From the first
  // 18 to the first 26.
  const auto ramp = known_staircase([](double w) { return 10 * w; });
  EXPECT_THAT(step_sharpness(ramp, 2.095, 20).value(),
              FieldsAre(2.095, 17, 26, DoubleNear(2.6 - 1.8, 1e-9), 1, Rise::climb));
}

TEST(StepSharpness, OfAShortRampBetweenLevelsIsItsLength) {
  const auto ramp = [](double length) {
    return known_staircase(
        [=](double w) { return w < 3 ? 6 : std::min(12.0, 6 + 6 * (w - 3) / length); });
  };
  // From the first 7, a sixth up the ramp, to its end.
  EXPECT_THAT(step_sharpness(ramp(0.3), 3.195, 9).value(),
              FieldsAre(_, _, _, DoubleNear(0.3 * 5 / 6, 1e-9), _, Rise::step));
  EXPECT_THAT(step_sharpness(ramp(0.6), 3.395, 9).value(),
              FieldsAre(_, _, _, DoubleNear(0.6 * 5 / 6, 1e-9), _, Rise::climb));
}

TEST(StepSharpness, OfWhatSoonIsQuietAgainIsNone) {
  // Loud from 4 to 4.5 rad/s, and not again before 6: a quarter of the stretch.
  const auto brief = known_staircase([](double w) { return w < 4 || w >= 4.5 ? 5 : 9; });
  EXPECT_THAT(step_sharpness(brief, 3.995, 7.5).value(),
              FieldsAre(_, _, 5, _, DoubleNear(0.25, 0.01), Rise::none));
}

TEST(StepSharpness, OfASmallStepThatPassesTheLimitIsAClimb) {
  // Seven to eight is sharp, and louder than 7.5, but no significant increase by itself.
  const auto small = known_staircase([](double w) { return w < 5 ? 7 : 8; });
  EXPECT_THAT(step_sharpness(small, 4.995, 7.5).value(), FieldsAre(_, _, _, 0, 1, Rise::climb));
}

TEST(StepSharpness, IsNotWidenedByLoneSpeeds) {
  SpeedScan scan = known_staircase([](double w) { return w < 9 ? 5 : 8; });
  for (const std::size_t k : {700U, 800U}) scan.counts[k] = 6;
  for (const std::size_t k : {1000U, 1100U}) scan.counts[k] = 5;
  EXPECT_THAT(step_sharpness(scan, 8.995, 7.5).value(),
              FieldsAre(_, _, _, 0, testing::Lt(1), Rise::step));
}

TEST(StepSharpness, LooksAsFarAsItReachesAndAsTheScanGoes) {
  // Loud again above 12 rad/s only: seen from 9, within a half and not within a fifth.
  const auto scan = known_staircase([](double w) { return w < 9 || w >= 12 ? 5 : 8; });
  EXPECT_EQ(step_sharpness(scan, 8.995, 7.5, 1.2)->persistence, 1);
  EXPECT_LT(step_sharpness(scan, 8.995, 7.5, 1.5)->persistence, 0.9);
  const auto late = known_staircase([](double w) { return w < 17 ? 5 : 8; });
  EXPECT_EQ(step_sharpness(late, 16.995, 7.5)->persistence, 1);
  EXPECT_FALSE(step_sharpness(late, 18.5, 7.5));
  EXPECT_FALSE(step_sharpness(late, 0.005, 7.5));
}

TEST(QuietIntervals, AreTheStretchesOfQuietSpeeds) {
  const SpeedScan scan{0.5, {2, 3, 4, 5, 3, 9, 1, 1, 1}};
  const auto found = quiet_intervals(scan, 3);
  EXPECT_THAT(found, ElementsAre(FieldsAre(0.5, 1.0), FieldsAre(2.5, 2.5), FieldsAre(3.5, 4.5)));
  EXPECT_EQ(found.front().width(), 0.5);
  EXPECT_THAT(quiet_intervals(scan, 0.5), IsEmpty());
  EXPECT_THAT(quiet_intervals(scan, 9), ElementsAre(FieldsAre(0.5, 4.5)));
}

}  // namespace
}  // namespace ricochet::carrier_track
