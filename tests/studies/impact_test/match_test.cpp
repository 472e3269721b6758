#include <gmock/gmock.h>

#include "src/studies/impact_test/score.h"

namespace ricochet::studies::impact_test {
namespace {

using carrier_track::Impact;
using carrier_track::Wall;
using testing::ElementsAre;
using testing::Optional;
using Place = std::size_t;

constexpr auto nobody = std::nullopt;

std::vector<Impact> on_lower(const std::vector<double>& times) {
  std::vector<Impact> impacts;
  for (const double t : times) impacts.push_back({t, Wall::lower, 1});
  return impacts;
}

TEST(Match, MakesAsManyPairsAsPossible) {
  // Greedily the first true one would take the second found one, and the last would have none.
  EXPECT_THAT(partners_of(on_lower({1.0, 1.5}), on_lower({0.6, 1.1}), 0.5),
              ElementsAre(Optional(Place{0}), Optional(Place{1})));
}

TEST(Match, TakesTheNearestAmongAsManyPairs) {
  EXPECT_THAT(partners_of(on_lower({1}), on_lower({0.9, 1.01, 1.2}), 0.5),
              ElementsAre(Optional(Place{1})));
}

TEST(Match, FindsTheOneThatIsMissing) {
  EXPECT_THAT(partners_of(on_lower({1, 2, 3, 4}), on_lower({1.1, 3.1, 4.1}), 0.5),
              ElementsAre(Optional(Place{0}), nobody, Optional(Place{1}), Optional(Place{2})));
}

TEST(Match, PairsNobodyTooFarAwayOrOnTheOtherWall) {
  const std::vector<Impact> found = {{1, Wall::upper, 1}, {1.6, Wall::lower, 1}};
  EXPECT_THAT(partners_of(on_lower({1}), found, 0.5), ElementsAre(nobody));
  EXPECT_THAT(partners_of(on_lower({1}), {}, 0.5), ElementsAre(nobody));
}

}  // namespace
}  // namespace ricochet::studies::impact_test
