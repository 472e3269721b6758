#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"
#include "tests/carrier_track/suite/machine_of_case.h"

namespace ricochet::carrier_track {
namespace {

/// C1, of which counts up to 6 shall be quiet.
Machine limited_machine() {
  Machine c1 = machine_of(find_case("C1"), exploratory_scene());
  c1.quiet_limit = 6;
  return c1;
}

TEST(TopSpeed, IsConstrainedByTheLimit) {
  const Problem problem = top_speed_problem(limited_machine());
  const Values quiet = problem.evaluate(at(9.0));
  EXPECT_EQ(quiet.objective, -9.0);
  EXPECT_LE(quiet.constraints[0], 0.0);
  EXPECT_GT(problem.evaluate(at(15.0)).constraints[0], 0.0);
}

TEST(TopSpeed, JudgesTheSurrogateByTheTrueCount) {
  const Problem problem = top_speed_problem(limited_machine()).formulated({0.25});
  EXPECT_EQ(problem.true_values(at(9.0)).violation, 0.0);
  EXPECT_EQ(problem.true_values(at(15.0)).violation, 1.0);
  EXPECT_EQ(problem.true_values(at(15.0)).objective, -15.0);
}

TEST(TopSpeed, HasASurrogateWithDerivatives) {
  expect_derivatives_of_values(top_speed_problem(limited_machine()).formulated({0.25}), at(4.321),
                               1e-7, 1e-6);
}

/// Where the count leaves the limit because an impact gets faster, a sharp surrogate passes its
/// level, whether the limit is a whole number or not.
TEST(TopSpeed, HasASurrogateThatPassesItsLevelWhereTheCountLeavesTheLimit) {
  Machine c1 = limited_machine();
  for (const double limit : {6.0, 6.5}) {
    c1.quiet_limit = limit;
    const Problem count = top_speed_problem(c1);
    const Problem sharp = top_speed_problem(c1).formulated({1e-5});
    int crossings = 0;
    for (double omega = 9; omega < 15; omega += 0.01) {
      const bool quiet = count.evaluate(at(omega)).constraints[0] <= 0;
      const double shown = sharp.evaluate(at(omega)).constraints[0];
      // Half a collision away from the level, it is on the same side as the count.
      if (std::abs(shown) > 0.01) {
        EXPECT_EQ(shown < 0, quiet) << omega;
      }
      crossings += quiet != (count.evaluate(at(omega + 0.01)).constraints[0] <= 0);
    }
    EXPECT_GT(crossings, 0);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
