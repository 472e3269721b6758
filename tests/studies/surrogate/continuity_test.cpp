#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {
namespace {

/// The change of f between two neighbouring numbers, found from its values at 17 points.
template <class Function>
double largest_jump(const Function& f) {
  std::vector<double> values;
  for (int k = 0; k <= 16; ++k) values.push_back(f(k / 16.0));
  return narrowed(steepest_piece(values), f).change();
}

TEST(Continuity, NarrowsAStepBesideASteepSlope) {
  const auto stair = [](double t) { return 0.2 * t * t + (t > 0.37 ? 0.3 : 0.0); };
  EXPECT_NEAR(largest_jump(stair), 0.3, 1e-15);
  EXPECT_LT(largest_jump([](double t) { return std::sin(20 * t); }), 1e-14);
  EXPECT_LT(largest_jump([](double t) { return std::sqrt(t); }), 1e-7);
}

TEST(Continuity, FindsTheCountsJumpsAndNoneOfTheSurrogate) {
  const Table table = changes({0.5, 0.25}, 162, 3);
  EXPECT_EQ(table.rows.size(), 162U);
  each_row(table, [](const Row& row) {
    EXPECT_LT(row.number("steepest"), largest_allowed);
    EXPECT_LT(row.number_if("strike").value_or(0), largest_allowed);
    // A root, or smoother; 0 would be a jump.
    EXPECT_GT(row.number_if("exponent").value_or(1), 0.4);
  });
  report::Results results;
  add_continuity(results, table);
  EXPECT_GT(number_in(*results.value("count-jumps")), 0.2);
  EXPECT_GT(number_in(*results.value("births")), 3);
  EXPECT_EQ(text_of(*results.value("continuous")), "Yes, up to rounding");
  const Table& continuity = *results.table("continuity");
  ASSERT_EQ(continuity.rows.size(), 4U);
  EXPECT_EQ(continuity[0].number("smoothing"), 0.5);
  EXPECT_EQ(continuity[0].text("where"), "steepest");
  EXPECT_EQ(continuity[0].number("segments") + continuity[2].number("segments"), 162);
}

TEST(Continuity, IsNotShownWhereAChangeIsTooLarge) {
  Table table{"changes", columns_named("smoothing,count_jumps,steepest,strike,exponent")};
  table.add(0.25, true, 1e-12, 2e-5, 0.1);
  table.add(0.25, false, 1e-12, std::nullopt, std::nullopt);
  report::Results results;
  add_continuity(results, table);
  EXPECT_EQ(text_of(*results.value("continuous")), "That is not shown");
  EXPECT_EQ(*results.value("jumps-larger"), value_of(1));
  EXPECT_EQ(*results.value("jump-worst"), value_of(2e-5));
  EXPECT_EQ(*results.value("count-jumps"), value_of(0.5));
  EXPECT_EQ(*results.value("exponents-low"), value_of(1));
}

TEST(Continuity, HasTheSameBitsForAnyNumberOfThreads) {
  const Table many = changes({0.25}, 54, 4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(changes({0.25}, 54, 4).rows, many.rows);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
