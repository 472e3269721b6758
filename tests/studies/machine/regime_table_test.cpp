#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/studies/machine/regime_tables.h"

namespace ricochet::studies::advice {
namespace {

using carrier_track::Regime;
using testing::ElementsAre;

Regime regime(double from, double to, double least, double most) {
  Regime one{};
  one.from = from;
  one.to = to;
  one.least_per_turn = least;
  one.most_per_turn = most;
  one.moves = one.certain = true;
  return one;
}

std::vector<double> ends_of(const std::vector<Regime>& regimes) {
  std::vector<double> ends;
  for (const Regime& one : regimes) ends.push_back(one.to);
  return ends;
}

TEST(RegimeTable, LeavesOutNarrowRegimesBetweenWiderOnes) {
  EXPECT_THAT(
      ends_of(without_narrow({regime(1, 1.005, 0, 0), regime(1.005, 2, 2, 2), regime(2, 2.01, 3, 3),
                              regime(2.01, 3, 4, 4), regime(3, 3.01, 5, 5)})),
      ElementsAre(1.005, 2, 3, 3.01));
}

TEST(RegimeTable, SaysOneNumberWhereAllTurnsAreAlike) {
  EXPECT_EQ(counts_of(regime(1, 2, 4, 4)), "4");
  EXPECT_EQ(counts_of(regime(1, 2, 1, 4)), "1 to 4");
}

TEST(RegimeTable, SaysWhereSilenceAndTheUsualLimitEnd) {
  const std::string text =
      summary_of({regime(0.01, 5.667, 0, 0), regime(5.667, 5.668, 1, 1), regime(5.668, 6.152, 2, 2),
                  regime(6.152, 6.153, 3, 3), regime(6.153, 18, 4, 4)});
  EXPECT_EQ(text,
            "silent up to 5.667 rad/s (54.12 rpm), at most 2 collisions a turn up to 6.152 rad/s "
            "(58.75 rpm), more beyond");
  EXPECT_EQ(summary_of({regime(1, 2, 2, 2), regime(2, 3, 0, 0)}),
            "at most 2 collisions a turn up to 3.000 rad/s (28.65 rpm)");
  EXPECT_EQ(summary_of({regime(1, 2, 0, 0), regime(2, 3, 4, 4), regime(3, 4, 2, 2)}),
            "silent up to 2.000 rad/s (19.10 rpm), more beyond");
  EXPECT_EQ(summary_of({regime(1, 2, 3, 3)}), "more than 2 collisions a turn");
}

}  // namespace
}  // namespace ricochet::studies::advice
