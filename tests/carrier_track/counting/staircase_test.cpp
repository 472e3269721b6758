#include "problems/carrier_track/counting/staircase.h"

#include "problems/carrier_track/counting/quiet_speed.h"
#include "ricochet/random.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::_, testing::DoubleNear, testing::Field;

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
  EXPECT_TRUE(
      std::ranges::equal(shorter.counts, std::span(longer.counts).first(shorter.counts.size())));
  EXPECT_GE(shorter.omega(0), 0.01);
  EXPECT_LE(shorter.omega(shorter.counts.size() - 1), 5);
  EXPECT_NEAR(std::log(shorter.omega(500) / shorter.omega(0)), 1, 1e-12);
}

TEST(Staircase, FindsOneStepWhereItIs) {
  const Staircase staircase = staircase_to(18, [](double w) { return w < 5 ? 4 : 9; });
  // omega, below, above, reach, misclassified and significance
  EXPECT_THAT(staircase.steps,
              ElementsAre(FieldsAre(DoubleNear(5, 5 * 0.001), 4, 9, 2, 0,
                                    DoubleNear(std::log(10.0 / 5.0) * std::log(2.0), 1e-12), _)));
  EXPECT_THAT(staircase.levels, ElementsAre(Field(&Level::typical, 4), Field(&Level::typical, 9)));
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
    EXPECT_THAT(staircase_of(scan, 18).steps, IsEmpty());
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

/// The cases and drawn machines, 200 together: constants up to e times larger or smaller.
std::vector<Scene> many_machines() {
  Random random(7);
  std::vector<Scene> machines;
  for (const Case& a_case : all_cases()) machines.push_back(case_scene(a_case.id));
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
    bool moves = false;
    for (const double fastest : {3.0, 7.0, 14.0, 18.0, 30.0}) {
      LogarithmicScan part = whole;
      while (part.omega(part.counts.size() - 1) > judged_share * fastest) part.counts.pop_back();
      const Staircase near = staircase_of(part, fastest);
      // Where a scan ends does not matter for a step within it.
      std::vector<testing::Matcher<Step>> within;
      for (const Step& step : far.steps) {
        if (step.omega > fastest) break;
        within.push_back(
            AllOf(Field(&Step::omega, step.omega), Field(&Step::significance, step.significance)));
      }
      EXPECT_THAT(near.steps, testing::ElementsAreArray(within)) << "to " << fastest;
      const auto here = near.main_step();
      if (fastest < 14 || (here ? here->omega == answer->omega : !answer)) continue;
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

TEST(StepSharpness, IsWhatTheStaircaseSays) {
  const auto jump = known_staircase([](double w) { return w < 9 ? 5 : 8; });
  SpeedScan lone_speeds = jump;
  for (const std::size_t k : {700U, 800U}) lone_speeds.counts[k] = 6;
  for (const std::size_t k : {1000U, 1100U}) lone_speeds.counts[k] = 5;
  const auto short_ramp = [](double length) {
    return known_staircase(
        [=](double w) { return w < 3 ? 6 : std::min(12.0, 6 + 6 * (w - 3) / length); });
  };
  struct Row {
    const char* what;
    SpeedScan scan;
    double threshold, limit;
    /// threshold, before, after, width, persistence and rise
    testing::Matcher<StepSharpness> sharpness;
  };
  for (const auto& [what, scan, threshold, limit, sharpness] : {
           Row{"a jump is a step without width", jump, 8.995, 7.5,
               FieldsAre(8.995, 5, 8, 0, 1, Rise::step)},
           {"lone speeds do not widen it", lone_speeds, 8.995, 7.5,
            FieldsAre(_, _, _, 0, testing::Lt(1), Rise::step)},
           // More than 20 from 2.1 rad/s on: medians at 1.75 and 2.62 rad/s, the width from the
           // first 18 to the first 26.
           {"a ramp climbs between the middles of its stretches",
            known_staircase([](double w) { return 10 * w; }), 2.095, 20,
            FieldsAre(2.095, 17, 26, DoubleNear(2.6 - 1.8, 1e-9), 1, Rise::climb)},
           // From the first 7, a sixth up the ramp, to its end.
           {"a short ramp has its length", short_ramp(0.3), 3.195, 9,
            FieldsAre(_, _, _, DoubleNear(0.3 * 5 / 6, 1e-9), _, Rise::step)},
           {"a longer one climbs", short_ramp(0.6), 3.395, 9,
            FieldsAre(_, _, _, DoubleNear(0.6 * 5 / 6, 1e-9), _, Rise::climb)},
           {"loud from 4 to 4.5 and not again before 6 rad/s: a quarter of the stretch",
            known_staircase([](double w) { return w < 4 || w >= 4.5 ? 5 : 9; }), 3.995, 7.5,
            FieldsAre(_, _, 5, _, DoubleNear(0.25, 0.01), Rise::none)},
           {"seven to eight passes the limit, and is no significant increase by itself",
            known_staircase([](double w) { return w < 5 ? 7 : 8; }), 4.995, 7.5,
            FieldsAre(_, _, _, 0, 1, Rise::climb)},
       }) {
    EXPECT_THAT(step_sharpness(scan, threshold, limit).value(), sharpness) << what;
  }
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
  EXPECT_THAT(quiet_intervals(scan, 3),
              ElementsAre(FieldsAre(0.5, 1.0), FieldsAre(2.5, 2.5), FieldsAre(3.5, 4.5)));
  EXPECT_EQ(quiet_intervals(scan, 3).front().width(), 0.5);
  EXPECT_THAT(quiet_intervals(scan, 0.5), IsEmpty());
  EXPECT_THAT(quiet_intervals(scan, 9), ElementsAre(FieldsAre(0.5, 4.5)));
}

}  // namespace
}  // namespace ricochet::carrier_track
