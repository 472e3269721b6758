#include "src/studies/reproduction/conclusions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "tests/carrier_track/questions/exploratory_scene.h"

namespace ricochet::studies::reproduction {
namespace {

/// Two restitutions, two frictions, two disturbances.
CountGrid hand_made(std::vector<double> means) {
  return {{0.1, 0.9}, {0.1, 0.4}, {0.0, 1.0}, std::move(means)};
}

TEST(Conclusions, HoldOnAGridThatChangesAsClaimed) {
  //                                         mu .1     mu .4     then with disturbance
  const auto found = trends(hand_made({4, 40, 3, 30, 8, 60, 6, 45}));
  ASSERT_EQ(found.size(), 3U);
  for (const Trend& trend : found) {
    EXPECT_EQ(trend.disagree, 0) << trend.conclusion;
    EXPECT_TRUE(trend.exceptions.empty()) << trend.conclusion;
  }
  EXPECT_EQ(found[0].agree, 2);
  EXPECT_EQ(found[0].weakest, 10);
  EXPECT_EQ(found[0].strongest, 10);
  EXPECT_EQ(found[1].agree, 2);
  EXPECT_DOUBLE_EQ(found[1].weakest, 4.0 / 3);
  EXPECT_EQ(found[2].agree, 4);
  EXPECT_DOUBLE_EQ(found[2].weakest, 1.5);
  EXPECT_DOUBLE_EQ(found[2].strongest, 2);
}

TEST(Conclusions, NameWhereTheyFail) {
  const auto found = trends(hand_made({4, 2, 3, 30, 8, 60, 2, 45}));
  EXPECT_EQ(found[0].disagree, 1);
  ASSERT_EQ(found[0].exceptions.size(), 1U);
  EXPECT_EQ(found[0].exceptions[0], "friction 0.1, from 0.1 to 0.9: 4.00 to 2.00");
  EXPECT_EQ(found[0].weakest, 0.5);
  EXPECT_EQ(found[1].disagree, 1);
  EXPECT_EQ(found[1].exceptions[0], "restitution 0.9, from 0.4 to 0.1: 30.00 to 2.00");
  EXPECT_EQ(found[2].disagree, 1);
  EXPECT_EQ(found[2].exceptions[0], "restitution 0.1, friction 0.4, from 0 to 1: 3.00 to 2.00");
}

TEST(Conclusions, CountNoChangeForNeitherSide) {
  const auto found = trends(hand_made({4, 4, 4, 4, 4, 4, 4, 4}));
  for (const Trend& trend : found) {
    EXPECT_EQ(trend.agree + trend.disagree, 0);
    EXPECT_EQ(trend.weakest, 1);
  }
}

TEST(Conclusions, RestOnTheMeanOfTheCountsOverTheSpeeds) {
  using namespace carrier_track;
  const Scene reading = exploratory_scene();
  const CountGrid grid = count_grid(reading, 3.0, true);
  ASSERT_EQ(grid.means.size(),
            grid.restitutions.size() * grid.frictions.size() * grid.disturbances.size());
  Scene scene = reading;
  scene.restitution_lower = scene.restitution_upper = grid.restitutions[4];
  scene.friction = grid.frictions[1];
  scene.disturbance = grid.disturbances[2];
  double sum = 0;
  for (const double omega : {3.0, 6.0, 9.0, 12.0, 15.0, 18.0}) sum += count_at(scene, omega);
  EXPECT_EQ(grid.mean(4, 1, 2), sum / 6);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
