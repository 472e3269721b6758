#include "src/report/polyline.h"

#include <gmock/gmock.h>

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;

std::vector<double> positions(const Series& series) {
  std::vector<double> kept;
  for (const auto& part : polylines(series)) {
    for (const Sample& sample : part) kept.push_back(sample.position);
  }
  return kept;
}

TEST(Polyline, LeavesOutTheMidstOfALevelLine) {
  const Range spread{1, 3};
  Series series{"", Mark::line, {{0, 1}, {1, 1}, {2, 1}, {3, 1, spread}, {4, 1, spread}}};
  series.samples.insert(series.samples.end(), {{5, 1, spread}, {6, 2}, {7, 2}});
  EXPECT_THAT(positions(series), ElementsAre(0, 2, 3, 5, 6, 7));
}

TEST(Polyline, LeavesGapsWhereValuesAreMissing) {
  const auto parts = polylines({"", Mark::line, {{0, 1}, {1, 1}, {2, {}}, {3, 1}}});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].size(), 2U);
  EXPECT_EQ(parts[1].size(), 1U);
}

TEST(Polyline, DrawsStepsByTheirCornersAlone) {
  const auto parts = polylines({"", Mark::steps, {{0, 5}, {1, 5}, {2, 5}, {3, 7}, {4, 7}, {5, 7}}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_THAT(parts[0], ElementsAre(AllOf(Field(&Sample::position, 0), Field(&Sample::value, 5)),
                                    AllOf(Field(&Sample::position, 3), Field(&Sample::value, 5)),
                                    AllOf(Field(&Sample::position, 3), Field(&Sample::value, 7)),
                                    AllOf(Field(&Sample::position, 5), Field(&Sample::value, 7))));
}

TEST(Polyline, HoldsAStepUntilItsSuccessorEvenIfThatIsUnknown) {
  const auto parts = polylines({"", Mark::steps, {{0, 5}, {1, {}}, {2, {}}}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_THAT(parts[0], ElementsAre(Field(&Sample::position, 0), Field(&Sample::position, 1)));
}

}  // namespace
}  // namespace ricochet::report
