#include "problems/carrier_track/regimes/border.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/shaken_table.h"

namespace ricochet::carrier_track {
namespace {

TEST(Border, FlipOfTheShakenTableHasItsClosedForm) {
  for (const double e : {0.2, 0.5, 0.8}) {
    const double flip = shaken_table::flip_strength(e);
    const SteadyMotion near = steady_motion(shaken_table::on_orbit(e, 0.95 * flip));
    const auto border = first_border(near, followed(near, shaken_table::speed_at(1.05 * flip)));
    EXPECT_EQ(border.kind, RegimeEnd::flip);
    EXPECT_NEAR(border.omega / shaken_table::speed_at(flip), 1, 1e-10) << e;
  }
}

TEST(Border, FoldOfTheShakenTableHasItsClosedForm) {
  for (const double e : {0.2, 0.5, 0.8}) {
    const double fold = shaken_table::fold_strength(e);
    const SteadyMotion near = steady_motion(shaken_table::on_orbit(e, 1.05 * fold));
    const auto border = first_border(near, followed(near, shaken_table::speed_at(0.98 * fold)));
    EXPECT_EQ(border.kind, RegimeEnd::fold);
    EXPECT_NEAR(border.omega / shaken_table::speed_at(fold), 1, 1e-10) << e;
  }
}

TEST(Border, ReleaseIsWhereTheForceEqualsFrictionAndPull) {
  Scene machine = default_machine();
  machine.start_position = machine.wall_lower;
  machine.start_velocity = 0;
  machine.slider_mass_radius = 0;
  const SteadyMotion still = steady_motion(at_speed(machine, 1.0));
  const auto border = first_border(still, followed(still, 2.0));
  EXPECT_EQ(border.kind, RegimeEnd::release);
  const double force = machine.friction * machine.normal_force + machine.pull;
  EXPECT_NEAR(border.omega / std::sqrt(force / machine.centrifugal_mass_radius), 1, 1e-12);
}

TEST(Border, AnImpactHasTheCountingLimitThere) {
  const SteadyMotion slow = steady_motion(at_speed(default_machine(), 7.0));
  const auto border = first_border(slow, followed(slow, 9.0));
  EXPECT_EQ(border.kind, RegimeEnd::counting_limit);
  EXPECT_EQ(border.before.collisions, 2);
  EXPECT_EQ(border.after.collisions, 3);
  // The third fastest impact of a turn.
  EXPECT_NEAR(rank_margin(border.before, 3), 0, 1e-10);
  EXPECT_LE(rank_margin(border.before, 3), 0);
  EXPECT_GT(rank_margin(border.after, 3), 0);
}

}  // namespace
}  // namespace ricochet::carrier_track
