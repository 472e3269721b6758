#include <gtest/gtest.h>

#include "src/studies/verification/verification.h"

namespace ricochet::studies {
namespace {

using carrier_track::Comparison;

Comparison comparison(bool certain, int count, int true_values) {
  Comparison c;
  c.certain = certain;
  c.count = count;
  c.true_values = true_values;
  c.matched = 2;
  c.time_error = 1e-9;
  return c;
}

TEST(Tally, SeparatesWrongCountsThatWereCalledCertainFromOthers) {
  const Table table = tally("some", {comparison(true, 3, 3), comparison(true, 3, 4),
                                     comparison(false, 3, 4), comparison(false, 3, 3)});
  const Row row = table[0];
  EXPECT_EQ(row.text("scenes"), "some");
  EXPECT_EQ(row.number("number"), 4);
  EXPECT_EQ(row.number("certain"), 0.5);
  EXPECT_EQ(row.number("wrong_certain"), 1);
  EXPECT_EQ(row.number("wrong_uncertain"), 1);
  EXPECT_EQ(row.number("matched"), 4) << "of those called certain";
}

TEST(Tally, LeavesOutWhatTheOracleBrokeOff) {
  Comparison broken = comparison(true, 3, 4);
  broken.compared = false;
  const Table table = tally("some", {broken, comparison(true, 3, 3)});
  EXPECT_EQ(table[0].number("capped"), 1);
  EXPECT_EQ(table[0].number("certain"), 1);
  EXPECT_EQ(table[0].number("wrong_certain"), 0);
}

TEST(Tally, TakesErrorsOnlyFromScenesWhoseImpactsAllMatch) {
  Comparison unmatched = comparison(true, 3, 3);
  unmatched.missed = 1;
  unmatched.time_error = 1;
  const Table table = tally("some", {unmatched, comparison(true, 3, 3)});
  EXPECT_EQ(table[0].number("time_error"), 1e-9);
  EXPECT_EQ(table[0].number("missed"), 1);
}

}  // namespace
}  // namespace ricochet::studies
