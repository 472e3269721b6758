#include <gtest/gtest.h>

#include "src/report/chart.h"

namespace ricochet::report {
namespace {

TEST(ChartCsv, HasARowForEverySampleAndLine) {
  Chart chart{.name = "c", .title = "t", .x = {"speed [rad/s]"}, .y = {"count, at most"}};
  chart.series = {{.label = "a \"b\"", .mark = Mark::points, .samples = {{1, 2.5}, {1e-7, {}}}},
                  {.label = "", .mark = Mark::line, .samples = {{0.1 + 0.2, 1.0 / 3}}}};
  chart.lines = {{Direction::vertical, 9, "paper"}, {Direction::horizontal, 3, "limit"}};
  EXPECT_EQ(csv_of(chart),
            "series,speed [rad/s],\"count, at most\"\n"
            "\"a \"\"b\"\"\",1,2.5\n"
            "\"a \"\"b\"\"\",1e-07,\n"
            ",0.3,0.3333333333\n"
            "paper,9,\n"
            "limit,,3\n");
}

TEST(ChartCsv, HasSpreadsNamesAndAreasWhereThereAreAny) {
  Chart chart{.name = "c", .title = "t", .x = {"x"}, .y = {"y"}};
  chart.series = {
      {.label = "s",
       .mark = Mark::points,
       .samples = {{.position = 1, .value = 2, .spread = Range{1.5, 2.5}, .name = "cobyla"},
                   {.position = 3, .value = 4}}}};
  chart.areas = {{.label = "quiet", .shade = 0.5, .parts = {{{0, {1, 2}}, {1, {1, 3}}}}}};
  EXPECT_EQ(csv_of(chart),
            "series,x,y,lower,upper,name\n"
            "s,1,2,1.5,2.5,cobyla\n"
            "s,3,4,,,\n"
            "quiet,0,,1,2,\n"
            "quiet,1,,1,3,\n");
}

TEST(ChartCsv, NamesCategories) {
  Chart chart{.name = "c", .title = "t", .x = {.label = "case"}, .y = {"y"}};
  chart.x.categories = {"C1", "C2"};
  chart.series = {{.label = "s", .mark = Mark::points, .samples = {{1, 4}}}};
  EXPECT_EQ(csv_of(chart), "series,case,y\ns,C2,4\n");
}

TEST(ChartCsv, HasARowForEveryCellFromTheTop) {
  Chart chart{.name = "c", .title = "t", .x = {.label = "family"}, .y = {.label = ""}};
  chart.x.categories = {"count", "wear"};
  chart.y.categories = {"below", "=above"};
  chart.heat_map = HeatMap{.label = "solved [%]", .rows = {{1, 2}, {3, {}}}};
  EXPECT_EQ(csv_of(chart),
            "row,family,solved [%]\n"
            "'=above,count,3\n"
            "'=above,wear,\n"
            "below,count,1\n"
            "below,wear,2\n");
}

}  // namespace
}  // namespace ricochet::report
