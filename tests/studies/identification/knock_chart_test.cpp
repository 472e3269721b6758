#include <gtest/gtest.h>

#include <cmath>

#include "src/identification/knock_fit.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;

TEST(KnockCharts, ShowEveryKnockAndEveryPredictedImpact) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const auto charts = knock_charts(loss, example_point(record));
  ASSERT_EQ(charts.size(), 2U);
  for (const report::Chart& chart : charts) report::check(chart);
  std::size_t knocks = 0;
  for (const report::Series& series : charts[0].series) knocks += series.samples.size();
  EXPECT_EQ(knocks, record.knocks.size());
  EXPECT_EQ(charts[1].series[1].samples.size(), record.knocks.size());
  // Most knocks are within three standard deviations of the prediction, 1 ms.
  int near = 0;
  for (const report::Sample& sample : charts[0].series[0].samples) {
    near += std::abs(*sample.value) < 3 ? 1 : 0;
  }
  EXPECT_GT(near, 0.85 * static_cast<double>(knocks));
}

}  // namespace
}  // namespace ricochet::studies::identification
