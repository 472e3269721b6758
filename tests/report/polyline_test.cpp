#include "src/report/polyline.h"

#include <gmock/gmock.h>

namespace ricochet::report {
namespace {

using testing::ElementsAre;

std::vector<double> positions(const Series& series) {
  std::vector<double> kept;
  for (const auto& part : polylines(series)) {
    for (const Sample& sample : part) kept.push_back(sample.position);
  }
  return kept;
}

TEST(Polylines, LeaveOutTheMidstOfALevelLine) {
  const Range spread{1, 3};
  Series series{"", Mark::line, {{0, 1}, {1, 1}, {2, 1}, {3, 1, spread}, {4, 1, spread}}};
  series.samples.insert(series.samples.end(), {{5, 1, spread}, {6, 2}, {7, 2}});
  EXPECT_THAT(positions(series), ElementsAre(0, 2, 3, 5, 6, 7));
}

TEST(Polylines, EndAtGaps) {
  const Series series{"", Mark::line, {{0, 1}, {1, 2}, {2, std::nullopt}, {3, 2}}};
  ASSERT_EQ(polylines(series).size(), 2U);
  EXPECT_THAT(positions(series), ElementsAre(0, 1, 3));
}

TEST(Polylines, HoldAStepUntilTheNext) {
  const Series series{"", Mark::steps, {{0, 1}, {1, 1}, {2, 3}, {4, 3}}};
  EXPECT_THAT(positions(series), ElementsAre(0, 2, 2, 4));
}

}  // namespace
}  // namespace ricochet::report
