#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "src/analysis/rating.h"

namespace ricochet::comparison {
namespace {

using testing::ElementsAre;

TEST(StratifiedSample, HasOneItemOfEachStratum) {
  // Values 0 to 11 in a mixed order; three strata of four.
  const std::vector<double> values = {5, 0, 11, 3, 8, 1, 10, 2, 9, 4, 7, 6};
  std::set<std::size_t> all;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto drawn = stratified_sample(values, 3, seed);
    ASSERT_EQ(drawn.size(), 3U);
    for (std::size_t stratum = 0; stratum < 3; ++stratum) {
      EXPECT_GE(values[drawn[stratum]], 4.0 * static_cast<double>(stratum));
      EXPECT_LT(values[drawn[stratum]], 4.0 * static_cast<double>(stratum) + 4);
    }
    all.insert(drawn.begin(), drawn.end());
    EXPECT_EQ(stratified_sample(values, 3, seed), drawn);
  }
  EXPECT_EQ(all.size(), values.size()) << "any may be drawn";
}

TEST(StratifiedSample, IsAllIfThereAreNoMore) {
  EXPECT_THAT(stratified_sample({2, 1, 2}, 3, 0), ElementsAre(1, 0, 2));
  EXPECT_THAT(stratified_sample({2, 1}, 5, 0), ElementsAre(1, 0));
  EXPECT_TRUE(stratified_sample({}, 3, 0).empty());
}

}  // namespace
}  // namespace ricochet::comparison
