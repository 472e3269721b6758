#include <gtest/gtest.h>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/studies/machine/charts.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;

TEST(StaircaseChart, ShowsEveryCountAndMarksSpeedsWithinTheRange) {
  const Scene scene = scene_of(find_case("C1"), default_machine());
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 3}, 1e-2, 9});
  const report::Chart chart =
      staircase_chart(answer, "C1", {{8.5, "a"}, {std::nullopt, "b"}, {9.5, "c"}});
  report::check(chart);
  std::vector<std::string> labels;
  for (const report::ReferenceLine& line : chart.lines) labels.push_back(line.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"a", "step", "step"}));
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
  const Scene scene = scene_of(find_case("C1"), default_machine());
  const QuietSpeed answer = quiet_speed(scene, {});
  const report::Chart chart = staircase_chart(answer, "C1", {{answer.fastest_quiet, "a"}});
  report::check(chart);
  const auto& samples = chart.series.at(0).samples;
  ASSERT_EQ(samples.size(), answer.regimes.size() + 1);
  for (std::size_t i = 0; i < answer.regimes.size(); ++i) {
    EXPECT_EQ(samples[i].position, answer.regimes[i].from);
    EXPECT_EQ(samples[i].value, answer.regimes[i].collisions_per_turn);
  }
  EXPECT_EQ(samples.back().position, 18);
}

}  // namespace
}  // namespace ricochet::studies::advice
