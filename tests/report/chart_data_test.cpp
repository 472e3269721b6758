#include "src/report/chart_data.h"

#include <gmock/gmock.h>

#include "src/report/gnuplot.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

Chart full_chart() {
  Chart chart = line_chart({{0.1, 1}, {1, 2.5, Range{2, 3}}, {2, std::nullopt}});
  chart.name = "full";
  chart.x = {"x [m]", Scale::logarithmic, Range{0.1, 10}};
  chart.series.push_back({"steps", Mark::steps, {{1, 2}, {2, 3}}});
  chart.series.push_back({"points", Mark::points, {{1, 2}}});
  chart.lines = {{Direction::vertical, 1.5, "limit"}, {Direction::horizontal, 2.0, "level"}};
  chart.width = 700;
  chart.description = "Words for those who cannot see.";
  return chart;
}

Chart heat_chart() {
  Chart chart;
  chart.name = "heat";
  chart.title = "Heat";
  chart.x.categories = {"a", "b"};
  chart.y.categories = {"c"};
  chart.heat_map = HeatMap{"count", {{1.25, std::nullopt}}, Range{0, 4}};
  return chart;
}

TEST(ChartData, MakeTheSamePictureAgain) {
  for (const Chart& chart : {full_chart(), heat_chart()}) {
    const Json data = Json::parse(data_of(chart).dump());
    const Chart again = chart_of(data);
    EXPECT_EQ(to_svgs({again}), to_svgs({chart}));
    EXPECT_EQ(data_of(again), data);
    EXPECT_EQ(again.description, chart.description);
  }
}

TEST(ChartData, LeaveOutTheMidstOfALevelLine) {
  const Range spread{1, 3};
  Chart chart = line_chart(
      {{0, 1}, {1, 1}, {2, 1}, {3, 1, spread}, {4, 1, spread}, {5, 1, spread}, {6, 2}, {7, 2}});
  const auto positions = [&chart] {
    std::vector<double> kept;
    const Chart again = chart_of(data_of(chart));
    for (const Sample& sample : again.series.at(0).samples) {
      kept.push_back(sample.position);
    }
    return kept;
  };
  EXPECT_THAT(positions(), testing::ElementsAre(0, 2, 3, 5, 6, 7));
  chart.series[0].mark = Mark::points;
  EXPECT_EQ(positions().size(), 8U);
}

TEST(ChartData, RefuseWhatIsNoChart) {
  EXPECT_THROW(chart_of(Json::object()), Json::exception);
  Json data = data_of(full_chart());
  data["series"][0]["mark"] = "dots";
  EXPECT_THROW(chart_of(data), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::report
