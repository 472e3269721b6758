#include "src/studies/reproduction/conclusions.h"

#include <gmock/gmock.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "src/studies/reproduction/sections.h"
#include "tests/carrier_track/suite/exploratory_scene.h"

namespace ricochet::studies::reproduction {
namespace {

/// Two restitutions, two frictions, two disturbances.
CountGrid hand_made(std::vector<double> means) {
  return {{0.1, 0.9}, {0.1, 0.4}, {0.0, 1.0}, std::move(means)};
}

void expect_reversal(const Trend& trend, const std::string& line, double from, double to,
                     double mean_from, double mean_to) {
  ASSERT_EQ(trend.exceptions.size(), 1U) << trend.conclusion;
  const Reversal& found = trend.exceptions[0];
  EXPECT_EQ(found.line, line);
  EXPECT_EQ(found.from, from) << line;
  EXPECT_EQ(found.to, to) << line;
  EXPECT_EQ(found.mean_from, mean_from) << line;
  EXPECT_EQ(found.mean_to, mean_to) << line;
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
  expect_reversal(found[0], "friction 0.1", 0.1, 0.9, 4, 2);
  EXPECT_EQ(found[0].weakest, 0.5);
  EXPECT_EQ(found[1].disagree, 1);
  expect_reversal(found[1], "restitution 0.9", 0.4, 0.1, 30, 2);
  EXPECT_EQ(found[2].disagree, 1);
  expect_reversal(found[2], "restitution 0.1, friction 0.4", 0, 1, 3, 2);
}

TEST(Conclusions, AreToldWithWhereTheyFail) {
  const CountGrid grid = hand_made({4, 2, 3, 30, 8, 60, 2, 45});
  report::Results results;
  add_conclusions(grid, trends(grid), results);
  const std::string told = text_of(*results.value("conclusions"));
  EXPECT_THAT(told,
              testing::HasSubstr("(A) fails between 1 of 2, such as friction 0.1, from 0.1 to "
                                 "0.9: 4.00 to 2.00;"));
  const Table& table = *results.table("conclusions");
  EXPECT_EQ(table[2].number("agree"), 3);
  EXPECT_EQ(table[2].number("disagree"), 1);
  const report::Chart& map = *results.chart("grid-most");
  EXPECT_EQ(map.heat_map->rows[1][0], 2) << "friction 0.4, restitution 0.1, disturbance 1 N";
  report::check(map);
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
  const Scene interpretation = exploratory_scene();
  const CountGrid grid = count_grid(interpretation, 3.0, true);
  ASSERT_EQ(grid.means.size(),
            grid.restitutions.size() * grid.frictions.size() * grid.disturbances.size());
  Scene scene = interpretation;
  scene.restitution_lower = scene.restitution_upper = grid.restitutions[4];
  scene.friction = grid.frictions[1];
  scene.disturbance = grid.disturbances[2];
  double sum = 0;
  for (const double omega : {3.0, 6.0, 9.0, 12.0, 15.0, 18.0}) sum += count_at(scene, omega);
  EXPECT_EQ(grid.mean(4, 1, 2), sum / 6);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
