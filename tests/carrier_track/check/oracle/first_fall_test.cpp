#include "problems/carrier_track/check/first_fall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

/// level + cos(t), whose first fall below zero is at acos(-level).
struct Raised {
  long double level;
  Jet operator()(long double t) const { return {level + std::cos(t), -std::sin(t), -std::cos(t)}; }
};

Search search(const Raised& f, long double horizon, long double guess) {
  const auto noise = [](long double) { return 1e-18L; };
  const auto never = [](long double) { return false; };
  return first_fall(f, {1, 1e-18L}, noise, never, horizon, guess);
}

TEST(FirstFall, IsolatesARootWhateverTheFirstPiece) {
  RandomScenes draws(1);
  for (int i = 0; i < 1000; ++i) {
    const Raised f{draws.within(-0.99, 0.99)};
    const long double expected = std::acos(-f.level);
    const Search found = search(f, draws.within(4, 1000), draws.log_within(1e-9, 1e3));
    ASSERT_EQ(found.end, Search::End::falls);
    ASSERT_LE(found.lower, expected);
    ASSERT_GE(found.upper, expected);
    ASSERT_NEAR(static_cast<double>(root_between(f, found.lower, found.upper) - expected), 0,
                1e-17);
  }
}

TEST(FirstFall, FindsADipOfTheSixteenthDigit) {
  for (const long double depth : {1e-6L, 1e-12L, 1e-16L}) {
    const Raised f{1 - depth};
    const Search found = search(f, 1000, 1);
    ASSERT_EQ(found.end, Search::End::falls) << static_cast<double>(depth);
    // The dip is only 2 sqrt(2 depth) wide.
    const long double width = std::sqrt(2 * depth);
    const long double root = root_between(f, found.lower, found.upper);
    EXPECT_NEAR(static_cast<double>((std::acos(-1.0L) - root) / width), 1, 0.1);
  }
}

TEST(FirstFall, TakesATouchForNoFall) {
  EXPECT_EQ(search({1}, 1000, 1).end, Search::End::never);
  EXPECT_EQ(search({1 + 1e-16L}, 1000, 1).end, Search::End::never);
}

TEST(FirstFall, EndsWhereTheCallersEventPasses) {
  const auto noise = [](long double) { return 1e-18L; };
  const auto passed = [](long double t) { return t >= 1; };
  const Search found = first_fall(Raised{0}, {1, 1e-18L}, noise, passed, 10.0L, 0.1L);
  EXPECT_EQ(found.end, Search::End::passes);
  EXPECT_LE(found.lower, 1);
  EXPECT_GE(found.upper, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
