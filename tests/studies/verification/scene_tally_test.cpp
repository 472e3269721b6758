#include <gtest/gtest.h>

#include "src/studies/verification/verification.h"

namespace ricochet::studies::verification {
namespace {

carrier_track::Comparison comparison(bool certain, int count, int true_values) {
  carrier_track::Comparison c;
  c.certain = certain;
  c.count = count;
  c.true_values = true_values;
  c.matched = 2;
  c.time_error = 1e-9;
  return c;
}

TEST(SceneTally, TellsWrongCountsThatWereCalledCertainFromOthers) {
  SceneTally tally{"some"};
  tally.add(comparison(true, 3, 3));
  tally.add(comparison(true, 3, 4));
  tally.add(comparison(false, 3, 4));
  tally.add(comparison(false, 3, 3));
  EXPECT_EQ(tally.scenes, 4);
  EXPECT_EQ(tally.certain, 0.5);
  EXPECT_EQ(tally.wrong_certain, 1);
  EXPECT_EQ(tally.wrong_uncertain, 1);
  EXPECT_EQ(tally.matched, 4);  // of those called certain
}

TEST(SceneTally, LeavesOutWhatTheOracleBrokeOff) {
  SceneTally tally{"some"};
  carrier_track::Comparison broken = comparison(true, 3, 4);
  broken.compared = false;
  tally.add(broken);
  tally.add(comparison(true, 3, 3));
  EXPECT_EQ(tally.compared(), 1);
  EXPECT_EQ(tally.broken_off, 1);
  EXPECT_EQ(tally.certain, 1.0);
  EXPECT_EQ(tally.wrong_certain, 0);
}

TEST(SceneTally, TakesErrorsOnlyFromScenesWhoseImpactsAllMatch) {
  SceneTally tally{"some"};
  carrier_track::Comparison unmatched = comparison(true, 3, 3);
  unmatched.missed = 1;
  unmatched.time_error = 1;
  tally.add(unmatched);
  EXPECT_EQ(tally.time_error, 0.0);
  tally.add(comparison(true, 3, 3));
  EXPECT_EQ(tally.time_error, 1e-9);
  EXPECT_EQ(tally.missed, 1);
}

}  // namespace
}  // namespace ricochet::studies::verification
