#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/machine/charts.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using testing::ElementsAre;

const RegimeMap& map_of_c1() {
  static const RegimeMap map = regime_map(scene_of(find_case("C1"), default_machine()),
                                          {{"restitution", 0.05, 0.95}, 13, {"omega", 0.5, 12}});
  return map;
}

/// The label of the area that holds a point; "" if none or several do.
std::string label_at(const report::Chart& chart, double position, double value) {
  std::string found;
  for (const report::Area& area : chart.areas) {
    for (const auto& part : area.parts) {
      for (std::size_t i = 0; i + 1 < part.size(); ++i) {
        if (position < part[i].position || position >= part[i + 1].position) continue;
        const double share =
            (position - part[i].position) / (part[i + 1].position - part[i].position);
        const auto& [a, b] = std::pair(part[i].between, part[i + 1].between);
        if (value < a.lower + share * (b.lower - a.lower)) continue;
        if (value >= a.upper + share * (b.upper - a.upper)) continue;
        if (!found.empty()) return "";
        found = area.label;
      }
    }
  }
  return found;
}

TEST(RegimeMapChart, ColoursRegionsByTheirCollisions) {
  const report::Chart chart = regime_map_chart(map_of_c1(), "C1", {}, {});
  report::check(chart);
  EXPECT_EQ(label_at(chart, 0.1, 1), "silent: no impact is fast enough to count");
  EXPECT_EQ(label_at(chart, 0.1, 5), "2 collisions a turn");
  EXPECT_EQ(label_at(chart, 0.1, 9), "4 collisions a turn");
  EXPECT_EQ(label_at(chart, 0.4, 10), "6 collisions a turn");
  EXPECT_LE(chart.areas.size(), 8U);
  for (std::size_t i = 0; i + 1 < chart.areas.size(); ++i) {
    EXPECT_GT(*chart.areas[i].shade, *chart.areas[i + 1].shade);  // louder is darker
  }
}

TEST(RegimeMapChart, NamesThePartsInWords) {
  const report::Chart chart =
      regime_map_chart(map_of_c1(), "C1", {}, {{{0.1, "C1: restitution 0.1"}}, {{0.1, 9, "C1"}}});
  report::check(chart);
  std::vector<std::string> labels;
  for (const report::Series& series : chart.series) labels.push_back(series.label);
  EXPECT_THAT(labels, ElementsAre("the paper's threshold", "border of the machine"));
  EXPECT_EQ(chart.lines.at(0).position, 0.1);
  EXPECT_EQ(chart.series[0].samples.at(0).name, "C1");
}

/// Every cell has one colour, also where parts of several columns are joined.
TEST(RegimeMapChart, ColoursEachCellOnce) {
  const RegimeMap& map = map_of_c1();
  const report::Chart chart = regime_map_chart(map, "C1", {}, {});
  std::set<std::string> labels;
  for (const MapColumn& column : map.columns) {
    const double position = std::clamp(column.value, 0.051, 0.949);
    for (const double height : map.heights) {
      const std::string label = label_at(chart, position, height);
      EXPECT_NE(label, "") << position << " " << height;
      labels.insert(label);
    }
  }
  EXPECT_GT(labels.size(), 4U);
}

TEST(RegimeMapChart, ShowsAConstantInItsUnit) {
  const RegimeMap map = regime_map(scene_of(find_case("C1"), default_machine()),
                                   {{"clearance", 0.5e-3, 1e-3}, 3, {"omega", 0.5, 4}});
  const report::Chart chart = regime_map_chart(map, "C1", {{"mm", 1e-3}}, {});
  report::check(chart);
  EXPECT_EQ(chart.x.label, "clearance [mm]");
  EXPECT_DOUBLE_EQ(chart.x.range->lower, 0.5);
  EXPECT_EQ(label_at(chart, 0.7, 1), "silent: no impact is fast enough to count");
}

}  // namespace
}  // namespace ricochet::studies::advice
