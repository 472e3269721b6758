#include "src/analysis/statistics/ranking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/numbers.h"

namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Ranking, IsByTheValueAndThenByTheCost) {
  EXPECT_THAT(ranking_of({Reached{7, 50}, Reached{6, 900}, Reached{7, 40}, Reached{8, 1}}),
              ElementsAre(ElementsAre(1), ElementsAre(2), ElementsAre(0), ElementsAre(3)));
}

TEST(Ranking, KeepsTiesTogetherAndLeavesOutWhoDidNotTakePart) {
  const Reached nothing{infinity, infinity};
  EXPECT_THAT(ranking_of({nothing, Reached{7, 40}, std::nullopt, Reached{7, 40}, nothing}),
              ElementsAre(ElementsAre(1, 3), ElementsAre(0, 4)));
  EXPECT_THAT(ranking_of({std::nullopt}), IsEmpty());
}

TEST(Ranking, IsNotOfWhatIsNoNumber) {
  EXPECT_THROW(ranking_of({Reached{std::nan(""), 1}}), std::invalid_argument);
  EXPECT_THROW(ranking_of({Reached{1, std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
