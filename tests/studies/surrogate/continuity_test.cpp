#include "src/studies/surrogate/continuity.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::studies::surrogate {
namespace {

TEST(LargestJump, IsThatOfAStepBesideASteepSlope) {
  const auto stair = [](double t) { return 0.2 * t * t + (t > 0.37 ? 0.3 : 0.0); };
  EXPECT_NEAR(largest_jump(stair), 0.3, 1e-15);
}

TEST(LargestJump, IsRoundingWhereThereIsNone) {
  EXPECT_LT(largest_jump([](double t) { return std::sin(20 * t); }), 1e-14);
  EXPECT_LT(largest_jump([](double t) { return std::sqrt(t); }), 1e-7);
}

TEST(LineFit, FindsTheSlopeOfALineAndNoneOfAPoint) {
  EXPECT_DOUBLE_EQ(*slope_of({{1, 5}, {2, 3}, {4, -1}}), -2);
  // Least squares of 0, 0, 1 over 0, 1, 2: 1/2.
  EXPECT_DOUBLE_EQ(*slope_of({{0, 0}, {1, 0}, {2, 1}}), 0.5);
  EXPECT_FALSE(slope_of({{1, 5}, {2, 3}}));
  EXPECT_FALSE(slope_of({{1, 5}, {1, 3}, {1, 4}}));
}

TEST(Continuity, FindsTheCountsJumpsAndNoneOfTheSurrogate) {
  const ContinuityStudy study = study_continuity({{0.5, 0.25}, 162, 3});
  ASSERT_EQ(study.rows.size(), 12U);
  std::size_t segments = 0;
  std::size_t count_jumps = 0;
  std::size_t births = 0;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
    for (const auto& jumps : row.jumps) {
      ASSERT_GE(jumps.size(), row.segments / 2);
      EXPECT_LT(jumps.back(), largest_allowed) << row.id;
    }
    for (const auto& jumps : row.births) {
      births += jumps.size();
      EXPECT_TRUE(jumps.empty() || jumps.back() < largest_allowed) << row.id;
    }
    // A root, or smoother; 0 would be a jump.
    for (const double exponent : row.exponents) EXPECT_GT(exponent, 0.4) << row.id;
  }
  EXPECT_EQ(segments, 162U);
  EXPECT_GT(count_jumps, 30U);
  EXPECT_GT(births, 3U);
}

TEST(Continuity, CallsASegmentOnWhichTheCountJumpsSo) {
  // The count of the ends differs, or that of one of 15 points between.
  const carrier_track::Scene scene =
      scene_of(carrier_track::find_case("C4"), carrier_track::default_machine());
  Random random(5);
  int jumps = 0;
  for (int i = 0; i < 12; ++i) {
    const Segment segment = random_segment(scene, random);
    const double largest =
        largest_jump([&](double t) { return carrier_track::objective(segment.at(t), 0.0); });
    EXPECT_EQ(jumps_of(segment, 0.25).of_count, largest >= 1);
    jumps += largest >= 1;
  }
  EXPECT_GT(jumps, 0);
  EXPECT_LT(jumps, 12);
}

TEST(Continuity, HasTheSameBitsForAnyNumberOfThreads) {
  const ContinuityPlan plan{{0.25}, 54, 4};
  const ContinuityStudy many = study_continuity(plan);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ContinuityStudy single = study_continuity(plan);
  for (std::size_t c = 0; c < many.rows.size(); ++c) {
    EXPECT_EQ(many.rows[c].jumps, single.rows[c].jumps);
    EXPECT_EQ(many.rows[c].count_jumps, single.rows[c].count_jumps);
  }
}

}  // namespace
}  // namespace ricochet::studies::surrogate
