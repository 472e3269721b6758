#include "problems/carrier_track/identification/knock_unknowns.h"

#include <gtest/gtest.h>

#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

TEST(KnockUnknowns, ArePointsAndBack) {
  const KnockUnknowns u{0.3, 0.2, 7e-4, 1.5, 1.01, 2e-3, 0.9, 0.4, 5e-3, 3, 0.2};
  const KnockUnknowns v = unknowns_at(point_of(u));
  EXPECT_NEAR(v.restitution, 0.3, 1e-15);
  EXPECT_NEAR(v.friction, 0.2, 1e-15);
  EXPECT_NEAR(v.clearance, 7e-4, 1e-18);
  EXPECT_EQ(v.phase, 1.5);
  EXPECT_NEAR(v.speed_factor, 1.01, 1e-15);
  EXPECT_NEAR(v.jitter, 2e-3, 1e-17);
  EXPECT_NEAR(v.recorded_share, 0.9, 1e-15);
  EXPECT_NEAR(v.spurious_rate, 0.4, 1e-15);
  EXPECT_NEAR(v.detection_limit, 5e-3, 1e-17);
  EXPECT_NEAR(v.gain, 3, 1e-14);
  EXPECT_NEAR(v.scatter, 0.2, 1e-15);
}

TEST(KnockUnknowns, HaveSlopesOfTheConstants) {
  const Vector x = point_of(guess_of(knocking_machine()));
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const auto constant = [&](double change) {
      Vector moved = x;
      moved[i] += change;
      const KnockUnknowns u = unknowns_at(moved);
      return i == 0 ? u.restitution : i == 1 ? u.friction : u.clearance;
    };
    EXPECT_NEAR(slopes_at(x)[i], (constant(1e-5) - constant(-1e-5)) / 2e-5, 1e-9);
  }
}

TEST(KnockUnknowns, BecomeConstantsOfAScene) {
  KnockUnknowns u = guess_of(knocking_machine());
  u.restitution = 0.25;
  u.friction = 0.15;
  u.clearance = 1e-3;
  Scene scene = knocking_machine();
  scene.wall_lower = 1;
  scene = with_constants(scene, u);
  EXPECT_EQ(scene.restitution_lower, 0.25);
  EXPECT_EQ(scene.restitution_upper, 0.25);
  EXPECT_EQ(scene.friction, 0.15);
  EXPECT_EQ(scene.wall_upper, 1.001);
  EXPECT_EQ(scene.start_position, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
