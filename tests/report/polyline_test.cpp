#include <gmock/gmock.h>

#include "src/report/svg.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;

TEST(Polyline, LeavesGapsWhereValuesAreMissing) {
  const auto parts = polylines({"", Mark::line, {{0, 1}, {1, 1}, {2, {}}, {3, 1}}});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].size(), 2U);
  EXPECT_EQ(parts[1].size(), 1U);
}

TEST(Polyline, GivesStepsTheirCorners) {
  const auto parts = polylines({"", Mark::steps, {{0, 5}, {3, 7}, {5, 7}}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_THAT(parts[0], ElementsAre(AllOf(Field(&Sample::position, 0), Field(&Sample::value, 5)),
                                    AllOf(Field(&Sample::position, 3), Field(&Sample::value, 5)),
                                    AllOf(Field(&Sample::position, 3), Field(&Sample::value, 7)),
                                    AllOf(Field(&Sample::position, 5), Field(&Sample::value, 7)),
                                    AllOf(Field(&Sample::position, 5), Field(&Sample::value, 7))));
}

TEST(Polyline, HoldsAStepUntilItsSuccessorEvenIfThatIsUnknown) {
  const auto parts = polylines({"", Mark::steps, {{0, 5}, {1, {}}, {2, {}}}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_THAT(parts[0], ElementsAre(Field(&Sample::position, 0), Field(&Sample::position, 1)));
}

}  // namespace
}  // namespace ricochet::report
