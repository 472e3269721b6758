#include <gmock/gmock.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "src/studies/reproduction/study.h"
#include "tests/support/scenes.h"

namespace ricochet::studies::reproduction {
namespace {

/// Two disturbances, two frictions, two restitutions, which change the fastest.
Table hand_made(const std::vector<double>& means) {
  Table grid{"grid", columns_named("restitution,friction,disturbance,mean")};
  std::size_t k = 0;
  for (const double disturbance : {0.0, 1.0})
    for (const double friction : {0.1, 0.4})
      for (const double restitution : {0.1, 0.9})
        grid.add(restitution, friction, disturbance, means.at(k++));
  return grid;
}

report::Results concluded(const std::vector<double>& means) {
  report::Results results;
  add_conclusions(hand_made(means), results);
  return results;
}

TEST(Conclusions, HoldOnAGridThatChangesAsClaimed) {
  //                                         mu .1  mu .4  then with disturbance
  const report::Results results = concluded({4, 40, 3, 30, 8, 60, 6, 45});
  const Table& found = *results.table("conclusions");
  ASSERT_EQ(found.rows.size(), 3U);
  each_row(found, [](const Row& row) { EXPECT_EQ(row.number("disagree"), 0); });
  EXPECT_THAT(text_of(*results.value("conclusions")),
              testing::HasSubstr("(B) holds between all 2 neighbours that differ; (C) holds"));
  EXPECT_EQ(found[0].number("agree"), 2);
  EXPECT_EQ(found[0].number("weakest"), 10);
  EXPECT_EQ(found[0].number("strongest"), 10);
  EXPECT_EQ(found[1].number("agree"), 2);
  EXPECT_DOUBLE_EQ(found[1].number("weakest"), 4.0 / 3);
  EXPECT_EQ(found[2].number("agree"), 4);
  EXPECT_DOUBLE_EQ(found[2].number("weakest"), 1.5);
  EXPECT_DOUBLE_EQ(found[2].number("strongest"), 2);
}

TEST(Conclusions, AreToldWithHowOftenTheyFail) {
  const report::Results results = concluded({4, 2, 3, 30, 8, 60, 2, 45});
  const Table& found = *results.table("conclusions");
  EXPECT_EQ(found[0].number("weakest"), 0.5);
  EXPECT_EQ(found[2].number("agree"), 3);
  EXPECT_EQ(found[2].number("disagree"), 1);
  EXPECT_EQ(text_of(*results.value("conclusions")),
            "(A) fails between 1 of 2; (B) fails between 1 of 2; (C) fails between 1 of 4.");
  const report::Chart& map = *results.chart("grid");
  EXPECT_EQ(map.heat_map->rows[1][1], 30) << "friction 0.4, restitution 0.9";
  report::check(map);
}

TEST(Conclusions, CountNoChangeForNeitherSide) {
  each_row(*concluded({4, 4, 4, 4, 4, 4, 4, 4}).table("conclusions"), [](const Row& row) {
    EXPECT_EQ(row.number("agree") + row.number("disagree"), 0);
    EXPECT_EQ(row.number("weakest"), 1);
  });
}

TEST(Conclusions, RestOnTheMeanOfTheCountsOverTheSpeeds) {
  using namespace carrier_track;
  const Scene interpretation = exploratory_scene();
  const Table grid = count_grid(interpretation, 3.0, true);
  ASSERT_EQ(grid.rows.size(), 5U * 4 * 3);
  const Row row = grid[2 * 20 + 5 + 4];
  EXPECT_EQ(row.number("restitution"), 0.9);
  EXPECT_EQ(row.number("friction"), 0.2);
  EXPECT_EQ(row.number("disturbance"), 1);
  const Scene scene = scene_of({"", 0.9, 0.2, 1, {}}, interpretation);
  double sum = 0;
  for (const double omega : {3.0, 6.0, 9.0, 12.0, 15.0, 18.0}) sum += count_at(scene, omega);
  EXPECT_EQ(row.number("mean"), sum / 6);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
