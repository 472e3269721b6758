#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/suite/planar_second_case.h"

namespace ricochet::carrier_track {
namespace {

Scene case_scene(const char* id) {
  return scene_of(find_case(id), default_machine());
}

/// The first scanned speed whose count is above the limit, by looking at every one.
double first_above(const Scene& scene, double limit) {
  for (int k = 1;; ++k) {
    if (count_at(scene, k * 1e-3) > limit) return k * 1e-3;
  }
}

TEST(QuietSpeed, IsTheSameWhereverTheRangeEnds) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {});
  ASSERT_TRUE(answer.fastest_quiet);
  for (const double fastest : {9.0, 14.0, 30.0}) {
    const QuietSpeed other = quiet_speed(scene, {std::nullopt, 1e-3, fastest});
    EXPECT_EQ(other.fastest_quiet, answer.fastest_quiet) << fastest;
    EXPECT_NEAR(*other.split.speed, *answer.split.speed, 1e-10) << fastest;
  }
}

TEST(QuietSpeed, IsMissingWhereEverySpeedIsLoud) {
  for (const auto& [restitution, clearance, per_turn] : {std::tuple(0.5, 0.8e-3, 2.0),
                                                         {0.9, 1e-3, 2.0},
                                                         {0.1, 2e-3, 0.0},
                                                         {0.7, 0.5e-3, 1.0},
                                                         {0.3, 4e-3, 1.0}}) {
    Scene scene = case_scene("C1");
    scene.restitution_lower = scene.restitution_upper = restitution;
    scene.wall_upper = scene.wall_lower + clearance;
    scene.friction = 0;
    scene.pull = 0;
    scene.counting_limit = 1e-6;
    const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions_per_turn, per_turn}});
    EXPECT_TRUE(answer.loud_everywhere) << restitution;
    EXPECT_FALSE(answer.fastest_quiet) << *answer.fastest_quiet;
    EXPECT_FALSE(answer.split.speed);
    EXPECT_EQ(answer.split.first_loud, 0.01) << "the slowest speed of the range";
    EXPECT_FALSE(answer.reached);
  }
  // By a window, too.
  const QuietSpeed window = quiet_speed(case_scene("C3"), {Limit{Measure::collisions, 0}, 1e-3, 4});
  EXPECT_FALSE(window.fastest_quiet);
  EXPECT_FALSE(window.split.speed);
  // Loud from the slowest speed on is not loud everywhere.
  const QuietSpeed quiet = quiet_speed(case_scene("C1"), {});
  EXPECT_FALSE(quiet.loud_everywhere);
}

TEST(QuietSpeed, SaysUpToWhereItIsKnownAtTheTimeLimit) {
  Scene scene = case_scene("C2");
  scene.window = Revolutions{2000};
  const QuietSpeedOptions options{Limit{Measure::collisions, 1e9}, 1e-3, 18};
  const TimeLimit limit(0.3);
  const QuietSpeed answer = quiet_speed(scene, options);
  ASSERT_TRUE(answer.reached);
  EXPECT_GT(*answer.reached, 0);
  EXPECT_LT(*answer.reached, 18);
  EXPECT_FALSE(answer.fastest_quiet);
  EXPECT_FALSE(answer.split.speed);
  EXPECT_FALSE(answer.loud_everywhere);
}

TEST(QuietSpeed, IsTheEndOfTwoCollisionsATurnInTheLongRun) {
  for (const char* id : {"C1", "C2", "C3", "C4", "C5", "C9"}) {
    const Scene scene = case_scene(id);
    const QuietSpeed answer = quiet_speed(scene, {});
    ASSERT_TRUE(answer.is_of_the_long_run());
    EXPECT_EQ(answer.limit->measure, Measure::collisions_per_turn);
    // 0 to 100 turns after the start, each for itself.
    const auto most_in_a_turn = [&](double omega) {
      Scene there = at_speed(scene, omega);
      int most = 0;
      int before = 0;
      for (int turns = 60; turns <= 160; ++turns) {
        there.window = Revolutions{static_cast<double>(turns) + 0.25};
        const int count = static_cast<int>(objective(there, 0.0));
        if (turns > 60) most = std::max(most, count - before);
        before = count;
      }
      return most;
    };
    EXPECT_LE(most_in_a_turn(*answer.fastest_quiet * (1 - 1e-3)), 2) << id;
    EXPECT_GT(most_in_a_turn(*answer.split.first_loud * (1 + 5e-3)), 2) << id;
  }
}

TEST(QuietSpeed, TakesAnotherLimitOfTheLongRun) {
  const Scene scene = case_scene("C1");
  const QuietSpeed silent = quiet_speed(scene, {Limit{Measure::collisions_per_turn, 0}, 1e-3, 18});
  EXPECT_NEAR(*silent.fastest_quiet, 1.447, 1e-3);
  const QuietSpeed four = quiet_speed(scene, {Limit{Measure::collisions_per_turn, 4}, 1e-3, 18});
  EXPECT_EQ(*four.fastest_quiet, 18);
  EXPECT_FALSE(four.split.first_loud);
}

TEST(QuietSpeed, KnowsBothStepsOfTheFirstCase) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 3}, 1e-3, 18});
  const std::vector<Step>& steps = answer.staircase.steps;
  ASSERT_EQ(steps.size(), 2U);
  for (const Step& step : steps) {
    EXPECT_NEAR(step.first_loud.value_or(0), first_above(scene, step.limit()), 1e-9);
    EXPECT_NEAR(step.omega, *step.first_loud, 2e-3);
  }
  EXPECT_NEAR(*answer.fastest_quiet, *steps[0].first_loud - 1e-3, 1e-9);
  ASSERT_EQ(answer.around.size(), 3U);
  EXPECT_LE(answer.around[1].count, answer.limit->at_most);
  EXPECT_GT(answer.around[2].count, answer.limit->at_most);
}

TEST(QuietSpeed, KeepsTheLimitThatIsGiven) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 6}, 1e-3, 18});
  EXPECT_NEAR(*answer.fastest_quiet, first_above(scene, 6) - 1e-3, 1e-9);
  const QuietSpeed any = quiet_speed(scene, {Limit{Measure::collisions, 1000}, 1e-3, 18});
  EXPECT_FALSE(any.split.first_loud);
  EXPECT_NEAR(*any.fastest_quiet, 18, 1e-9);
  const QuietSpeed nothing = quiet_speed(scene, {Limit{Measure::collisions, 0}, 1e-3, 18});
  EXPECT_FALSE(nothing.fastest_quiet);
}

TEST(QuietSpeed, FindsALoudWindowThatTheFineScanStepsOver) {
  RandomScenes random(79);
  for (int i = 0; i < 372; ++i) random.next();
  const Scene scene = random.next();
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 3}, 1e-3, 18});
  EXPECT_GT(first_above(scene, 3), 4.446);
  ASSERT_TRUE(answer.stepped_over);
  EXPECT_EQ(count_at(scene, answer.stepped_over->from), 4);
  EXPECT_EQ(answer.split.first_loud, answer.stepped_over->from);
  EXPECT_LT(answer.stepped_over->to - answer.stepped_over->from, 1e-3);
  EXPECT_NEAR(*answer.fastest_quiet, 4.445, 1e-9);
  EXPECT_FALSE(quiet_speed(case_scene("C1"), {}).stepped_over);
}

TEST(QuietSpeed, SaysThatThereIsNoThresholdWhereTheCountRisesThroughout) {
  const QuietSpeed answer = quiet_speed(planar_second_case(), {});
  EXPECT_TRUE(answer.staircase.steps.empty());
  EXPECT_FALSE(answer.limit);
  EXPECT_FALSE(answer.fastest_quiet);
  EXPECT_GT(answer.staircase.levels.front().high, 2 * answer.staircase.levels.front().low);
}

TEST(QuietSpeed, RefusesWhatIsInvalid) {
  Scene scene = case_scene("C1");
  const QuietSpeedOptions refused[] = {{.limit = {}, .fastest = 0.01},
                                       {.limit = {}, .fastest = 1001},
                                       {.limit = {}, .step = 0},
                                       {.limit = Limit{Measure::collisions, -1}}};
  for (const QuietSpeedOptions& options : refused) {
    EXPECT_THROW(quiet_speed(scene, options), InputError);
  }
  scene.profile = {{0.0, 1.0}, {1.0, 2.0}};
  EXPECT_THROW(quiet_speed(scene), InputError) << "a profile";
  scene.profile.clear();
  scene.restitution_lower = 2;
  EXPECT_THROW(quiet_speed(scene), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
