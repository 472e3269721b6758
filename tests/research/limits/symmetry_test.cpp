#include "src/research/limits/symmetry.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/counting/threshold.h"
#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

TEST(Symmetries, KeepEveryCountWithoutDisturbance) {
  for (const Interpretation& interpretation : {usual_fit().interpretation, Interpretation{}}) {
    const SymmetryChecks checks = check_symmetries(interpretation, 2, 40, 1);
    EXPECT_EQ(checks.space.counts, 160);
    EXPECT_EQ(checks.space.alike, 160);
    EXPECT_EQ(checks.time.counts, 160);
    EXPECT_EQ(checks.time.alike, 160);
  }
}

TEST(Symmetries, AreBrokenByADisturbance) {
  const Fit fit = usual_fit();
  const Case c9 = find_case("C9");
  int other_in_space = 0, other_in_time = 0;
  for (int k = 1; k <= 50; ++k) {
    const double omega = 0.3 * k;
    const int count = count_at(scene_of(c9, fit.interpretation, fit.constants), omega);
    const auto of = [&](const Constants& constants, double speed) {
      return count_at(scene_of(c9, fit.interpretation, constants), speed);
    };
    other_in_space += of(scaled_in_space(fit.constants, 0.25), omega) == count ? 0 : 1;
    other_in_time += of(scaled_in_time(fit.constants, 0.25), 0.25 * omega) == count ? 0 : 1;
  }
  EXPECT_GT(other_in_space, 0);
  EXPECT_GT(other_in_time, 0);
}

}  // namespace
}  // namespace ricochet::studies::limits
