#include "src/studies/machine/charts.h"

#include "problems/carrier_track/counting/threshold.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Chart;
using testing::Field;

/// Bounces between elastic walls 1 m apart at 2 m/s.
const Scene bouncing = with(Scene{}, set::start_velocity(2), set::omega(3), set::seconds(1.5));

Chart path_of(const Scene& scene) {
  const Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
  report::check(chart);
  return chart;
}

TEST(PathChart, ShowsMillimetresOverSecondsOrTurnsAsTheWindow) {
  const Chart chart = path_of(bouncing);
  EXPECT_EQ(chart.x.label, "time [s]");
  ASSERT_EQ(chart.series.size(), 2U);
  const auto& samples = chart.series[0].samples;
  EXPECT_EQ(samples.front().position, 0);
  EXPECT_EQ(samples.front().value, 500);
  EXPECT_NEAR(samples.back().position, 1.5, 1e-12);
  ASSERT_EQ(chart.lines.size(), 2U);
  EXPECT_EQ(chart.lines[1].position, 1000);
  const Chart in_turns = path_of(with(bouncing, set::revolutions(0.75)));
  EXPECT_EQ(in_turns.x.label, "driver plate [turns]");
  EXPECT_NEAR(in_turns.series[0].samples.back().position, 0.75, 1e-12);
  const Chart endless = path_of(with(bouncing, set::wall_upper(infinity)));
  EXPECT_EQ(endless.lines.size(), 1U) << "no wall at infinity";
  EXPECT_FALSE(endless.y.range.has_value());
}

TEST(PathChart, MarksWhatTheRuleCounts) {
  const Scene falling_back = with(bouncing, set::pull(20));  // from its first summit
  const report::Series impacts = path_of(falling_back).series.at(1);
  EXPECT_EQ(impacts.label, "impact that counts");
  EXPECT_THAT(impacts.samples, AllOf(Not(IsEmpty()), Each(Field(&report::Sample::value, 0))))
      << "lower wall";
  const report::Series maxima = path_of(with(falling_back, set::rule(CountRule::peaks),
                                             set::peak_high(0.55), set::peak_low(0.1)))
                                    .series.at(1);
  EXPECT_EQ(maxima.label, "maximum that counts");
  ASSERT_FALSE(maxima.samples.empty());
  for (const report::Sample& mark : maxima.samples)
    EXPECT_NEAR(*mark.value, 1e3 * (0.5 + 2.0 * 2.0 / (2 * 20)), 1e-6) << "the summit";
}

TEST(PathChart, ZoomsWhereMostHappens) {
  // Falls on the lower wall, and rests there from about 0.15 s on.
  const Scene scene = with(Scene{}, set::start_position(0.05), set::restitution_lower(0.5),
                           set::pull(40), set::seconds(5));
  const Recording recording = record(scene, 0.25, 100);
  const auto chart = zoom_chart(scene, recording);
  ASSERT_TRUE(chart);
  report::check(*chart);
  EXPECT_GE(chart->x.range->lower, 0);
  EXPECT_LT(chart->x.range->upper, 0.3);
  const auto& path = chart->series.at(0).samples;
  EXPECT_GT(path.size(), 1000U);
  for (const report::Sample& sample : path) {
    EXPECT_TRUE(sample.position >= chart->x.range->lower &&
                sample.position <= chart->x.range->upper && *sample.value < chart->y.range->upper);
  }
  EXPECT_LT(chart->y.range->upper, 60);
  ASSERT_EQ(chart->lines.size(), 1U) << "the upper wall is far away";
  EXPECT_EQ(chart->lines[0].position, 0);
  EXPECT_GE(3 * chart->series.at(1).samples.size(), 2 * static_cast<std::size_t>(recording.count));
  EXPECT_FALSE(zoom_chart(bouncing, record(bouncing, 0.25, 100)));
}

TEST(StaircaseChart, ShowsEveryCountAndMarksSpeedsWithinTheRange) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 3}, 1e-2, 9});
  const Chart chart = staircase_chart(answer, "C1", {{8.5, "a"}, {std::nullopt, "b"}, {9.5, "c"}});
  report::check(chart);
  const auto label = [](const char* text) { return Field(&report::ReferenceLine::label, text); };
  EXPECT_THAT(chart.lines, ElementsAre(label("a"), label("step"), label("step")));
  EXPECT_EQ(chart.lines[1].position, answer.staircase.steps[0].omega);
  const auto& samples = chart.series.at(0).samples;
  ASSERT_GT(samples.size(), 3U);
  for (const report::Sample& sample : samples) {
    EXPECT_LE(sample.position, 9);
    EXPECT_EQ(sample.value, count_at(scene, sample.position));
    EXPECT_LT(*sample.value, chart.y.range->upper);
  }
}

TEST(StaircaseChart, ShowsTheRegimesOfTheLongRun) {
  const QuietSpeed answer = quiet_speed(case_scene("C1"), {});
  const Chart chart = staircase_chart(answer, "C1", {{answer.fastest_quiet, "a"}});
  report::check(chart);
  const auto& samples = chart.series.at(0).samples;
  ASSERT_EQ(samples.size(), answer.regimes.size() + 1);
  for (std::size_t i = 0; i < answer.regimes.size(); ++i) {
    EXPECT_EQ(samples[i].position, answer.regimes[i].from);
    EXPECT_EQ(samples[i].value, answer.regimes[i].collisions_per_turn);
  }
  EXPECT_EQ(samples.back().position, 18);
}

/// The label of the area that holds a point; "" if none or several do.
std::string label_at(const Chart& chart, double position, double value) {
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

TEST(RegimeMapChart, ColoursRegionsByTheirCollisionsEachCellOnce) {
  const RegimeMap map =
      regime_map(case_scene("C1"), {{"restitution", 0.05, 0.95}, 13, {"omega", 0.5, 12}});
  const Chart chart =
      regime_map_chart(map, "C1", {}, {{{0.1, "C1: restitution 0.1"}}, {{0.1, 9, "C1"}}});
  report::check(chart);
  EXPECT_THAT(chart.series, ElementsAre(Field(&report::Series::label, "the paper's threshold"),
                                        Field(&report::Series::label, "border of the machine")));
  EXPECT_EQ(chart.lines.at(0).position, 0.1);
  EXPECT_EQ(chart.series[0].samples.at(0).name, "C1");
  EXPECT_EQ(label_at(chart, 0.1, 1), "silent: no impact is fast enough to count");
  EXPECT_EQ(label_at(chart, 0.1, 5), "2 collisions a turn");
  EXPECT_EQ(label_at(chart, 0.1, 9), "4 collisions a turn");
  EXPECT_EQ(label_at(chart, 0.4, 10), "6 collisions a turn");
  EXPECT_LE(chart.areas.size(), 8U);
  for (std::size_t i = 0; i + 1 < chart.areas.size(); ++i) {
    EXPECT_GT(*chart.areas[i].shade, *chart.areas[i + 1].shade);  // louder is darker
  }
  // Every cell has one colour, also where parts of several columns are joined.
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
  const RegimeMap map =
      regime_map(case_scene("C1"), {{"clearance", 0.5e-3, 1e-3}, 3, {"omega", 0.5, 4}});
  const Chart chart = regime_map_chart(map, "C1", {{"mm", 1e-3}}, {});
  report::check(chart);
  EXPECT_EQ(chart.x.label, "clearance [mm]");
  EXPECT_DOUBLE_EQ(chart.x.range->lower, 0.5);
  EXPECT_EQ(label_at(chart, 0.7, 1), "silent: no impact is fast enough to count");
}

}  // namespace
}  // namespace ricochet::studies::advice
