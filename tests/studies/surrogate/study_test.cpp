#include "src/studies/surrogate/study.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/studies/surrogate/derivative_check.h"
#include "src/studies/surrogate/grazes.h"

namespace ricochet::studies {
namespace {

using namespace surrogate;
using testing::HasSubstr;
using testing::Not;

TEST(SurrogateStudy, FillsItsPageAndDrawsItsCharts) {
  report::Json data = surrogate_study().compute(true);
  data["made"] = {{"version", "1.2.3"},
                  {"compiler", "GCC"},
                  {"threads", 2},
                  {"seconds", 4.5},
                  {"date", "2026-01-01"}};
  const report::Results results = report::results_of(data);
  const auto page = report::page_source(report::page_template("surrogate"));
  const report::PageFiles written = page_files(page, results);
  EXPECT_TRUE(written.failures.empty());
  for (const char* chart : {"speed-gap.svg", "continuity.svg", "validity-trend.svg"}) {
    EXPECT_TRUE(written.files.contains(chart)) << chart;
  }
  const std::string text = written.files.at("summary.md");
  for (const char* section : {"## How large is the surrogate's bias?", "## Is the surrogate cont",
                              "## Where does the gradient mean", "## Are the derivatives right?"}) {
    EXPECT_THAT(text, HasSubstr(section));
  }
  for (const Table& table : results.tables) {
    if (table.name != "unexplained") {
      EXPECT_FALSE(table.rows.empty()) << table.name;
    }
  }
  EXPECT_THAT(terminal_text(page, results), HasSubstr("At smoothing parameter 0.25"));
}

/// A case that is truly quiet up to 5 rad/s, at two smoothing parameters.
CaseBias case_of(const char* id, double wide, double narrow) {
  const auto at = [](double smoothing, double speed) {
    return Bias{smoothing, 0.1, 0.9, 0, speed, 5 - speed, speed > 5};
  };
  return {id, 1, 5, {at(0.25, wide), at(0.001, narrow)}};
}

TEST(SurrogateStudy, SaysHowFarTheFastestQuietSpeedIsOff) {
  report::Results results;
  add_to(results, BiasStudy{{0.01, {0.25, 0.001}},
                            {case_of("A", 6, 5), case_of("B", 8, 5.02), case_of("C", 4.5, 5)}});
  // |5 - 6|, |5 - 8| and |5 - 4.5|: the median is 1, the largest 3, and two are too fast.
  EXPECT_EQ(results.value("finding")->index(), 4U);
  const std::string finding = std::get<std::string>(*results.value("finding"));
  EXPECT_THAT(finding, HasSubstr("off by 1.00 rad/s in the median of 3 cases, by 3.00 at worst, "
                                 "and truly loud in 2;"));
  EXPECT_THAT(finding, HasSubstr("at 0.001 it is off by 0.00 and 0.02 rad/s, but still truly loud "
                                 "in 1."));
  EXPECT_THAT(std::get<std::string>(*results.value("bias-side")),
              HasSubstr("In 3 of 6 pairs of a case and a smoothing parameter the surrogate's "
                        "top speed in the window is too high, in 1 too low and in 2 right"));
  const Table& speeds = *results.table("quiet-speeds");
  EXPECT_EQ(speeds[1].number("at_0.25"), 8);
  EXPECT_EQ(speeds[1].number("fastest"), 5);
  EXPECT_EQ(results.table("bias")->rows.size(), 6U);
}

TEST(SurrogateStudy, CountsPointsWithoutATrendAmongAll) {
  // Of 10 points 6 can be compared, and 3 of these have the right sign.
  GradientQuality quality;
  quality.points = 10;
  quality.trending = 6;
  quality.right = 3;
  report::Results results;
  add_to(results, GradientDoubtStudy{{1, 10, {0.25}, {}}, {{"C1", {quality}}}, {quality}});
  const Row row = (*results.table("validity"))[0];
  EXPECT_DOUBLE_EQ(row.number("right"), 0.3);
  EXPECT_DOUBLE_EQ(row.number("wrong"), 0.3);
  EXPECT_DOUBLE_EQ(row.number("no_trend"), 0.4);
  EXPECT_DOUBLE_EQ(row.number("trending"), 0.5);
  EXPECT_THAT(results.chart("validity-trend")->title,
              HasSubstr("at 30 % of all points; 40 % have no trend"));
  EXPECT_EQ(results.chart("validity-trend")->heat_map->rows[0][0], 50);
}

TEST(SurrogateStudy, CountsGrazesAtEverySmoothingParameterByItself) {
  const std::vector<Approach> near = {{1e-12, -500, 3, 1e-12, 1e-12}};
  const auto graze = [&](double wide, double narrow) {
    return GrazeRow{"C1", {2, 1, carrier_track::Wall::upper, 1}, {near, near}, {wide, narrow}};
  };
  report::Results results;
  add_to(results, GrazeStudy{{400, 3, {0.25, 0.05}, {1e-12}},
                             {graze(-0.5, 0.99), graze(-0.51, -0.49), graze(1, 1)}});
  const Table& growth = *results.table("graze-growth");
  EXPECT_EQ(growth[0].number("growing"), 2);
  EXPECT_EQ(growth[0].number("finite"), 1);
  EXPECT_EQ(growth[0].number("least"), -0.51);
  EXPECT_EQ(growth[0].number("steepest"), 500);
  EXPECT_EQ(growth[1].number("growing"), 1);
  EXPECT_EQ(growth[1].number("most"), -0.49);
}

}  // namespace
}  // namespace ricochet::studies
