#include <gtest/gtest.h>

#include "src/core/instance.h"

namespace ricochet {
namespace {

TEST(Seed, IsFnv1aOfTheNamesAndNumbers) {
  // FNV-1a of the bytes "a" FF "b" FF "1" FF "2" FF, computed independently.
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint64_t c : {0x61U, 0xFFU, 0x62U, 0xFFU, 0x31U, 0xFFU, 0x32U, 0xFFU}) {
    hash = (hash ^ c) * 0x100000001b3;
  }
  EXPECT_EQ(seed_of("a", "b", 1, 2), hash);
}

TEST(Seed, TellsWhereANameEnds) {
  EXPECT_NE(seed_of("ab", "c", 1, 2), seed_of("a", "bc", 1, 2));
  EXPECT_NE(seed_of("a", "b", 12, 3), seed_of("a", "b", 1, 23));
}

TEST(Seed, TellsApartWhatIsShownInDifferentWays) {
  EXPECT_EQ(seed_of("a", "b", 1, 2, ""), seed_of("a", "b", 1, 2)) << "as it ever was";
  EXPECT_NE(seed_of("a", "b", 1, 2, "count"), seed_of("a", "b", 1, 2));
  EXPECT_NE(seed_of("a", "b", 1, 2, "count"), seed_of("a", "b", 1, 2, "surrogate"));
  EXPECT_NE(seed_of("a", "b", 1, 2, "3"), seed_of("a", "b", 1, 23));
}

}  // namespace
}  // namespace ricochet
