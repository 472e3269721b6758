#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/analysis/statistics/ranking.h"

namespace ricochet {
namespace {

TEST(Ranks, AreSharedByEqualValues) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ranks_of({3, 1, 3, infinity, 3, infinity}),
              testing::ElementsAre(3, 1, 3, 5.5, 3, 5.5));
  EXPECT_THAT(ranks_of({}), testing::IsEmpty());
}

TEST(Ranks, AreNotOfWhatIsNoNumber) {
  EXPECT_THROW(ranks_of({1, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
