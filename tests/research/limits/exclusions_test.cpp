#include "src/research/limits/exclusions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ricochet/solvers.h"
#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

TEST(Exclusions, SetEachClaimBesideAControlThatDropsNone) {
  FitStore store(no_file_yet());
  const Exclusions all = exclusions({usual_fit()}, {solver_named("nlopt-sbplx"), 8, {1, 2}}, store);
  const CoarseJudgement start = judged_coarsely(usual_fit().interpretation, usual_fit().constants);
  EXPECT_DOUBLE_EQ(all.start, loss_without(start, {}));
  ASSERT_EQ(all.controls.size(), 2U);
  EXPECT_EQ(all.all.size(), dropped_groups().size());
  for (const double control : all.controls) EXPECT_LE(control, all.start);
  EXPECT_TRUE(std::is_sorted(
      all.all.begin(), all.all.end(),
      [](const Exclusion& a, const Exclusion& b) { return a.relief() > b.relief(); }));
  for (const Exclusion& e : all.all) {
    EXPECT_NEAR(e.its_share + e.rest, all.controls.front(), 1e-9) << e.dropped.name;
    EXPECT_LE(e.rest_without, loss_without(start, e.dropped) + 1e-9) << e.dropped.name;
    EXPECT_LE(e.gains.size(), 3U);
    for (const Exclusion::Gain& gain : e.gains) {
      EXPECT_GT(gain.gain, 0);
      for (const Claimed& claim : e.dropped.claims) EXPECT_NE(gain.name, claim.name());
    }
  }
}

TEST(Exclusions, SpreadIsFromTheLowestToTheHighestControl) {
  Exclusions all;
  all.controls = {20.5, 20, 22};
  EXPECT_EQ(all.spread(), 2);
}

}  // namespace
}  // namespace ricochet::studies::limits
