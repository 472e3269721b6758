#include <gtest/gtest.h>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/studies/machine/answer.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;

constexpr Limit seven{Measure::collisions, 7};

ModelChoice choice_for(const Scene& scene) {
  return model_choice(scene, quiet_speed(scene, {seven, 1e-2, 18}));
}

/// A machine whose carrier starts off its track in the middle of a clearance across.
Scene machine_with_room_across() {
  Scene scene = scene_of(find_case("C1"), default_machine());
  scene.contact_friction = false;
  scene.across.emplace();
  scene.across->wall_upper = 1e-3;
  scene.across->start_position = 5e-4;
  return scene;
}

TEST(ModelChoice, IsAlongTheTrackWhereThereIsNoRoomAcross) {
  const ModelChoice choice = choice_for(scene_of(find_case("C1"), default_machine()));
  EXPECT_FALSE(choice.across);
  EXPECT_FALSE(choice.needed);
  EXPECT_FALSE(choice.planar);
}

TEST(ModelChoice, IsAlongTheTrackWhereFrictionHoldsTheCarrier) {
  Scene scene = machine_with_room_across();
  scene.slider_mass_radius = 0;
  const ModelChoice choice = choice_for(scene);
  EXPECT_TRUE(choice.across);
  EXPECT_FALSE(choice.needed);
}

TEST(ModelChoice, IsPlanarWhereAPullAcrossBeatsFriction) {
  Scene scene = machine_with_room_across();
  scene.across->pull = 10 * scene.friction * scene.normal_force;
  const ModelChoice choice = choice_for(scene);
  EXPECT_TRUE(choice.needed);
  scene.fidelity = Fidelity::planar;
  const QuietSpeed planar = quiet_speed(scene, {seven, 1e-2, 18});
  ASSERT_TRUE(planar.fastest_quiet);
  EXPECT_NEAR(choice.planar.value(), *planar.fastest_quiet, 0.03 * *planar.fastest_quiet);
  EXPECT_TRUE(choice.along);
}

}  // namespace
}  // namespace ricochet::studies::advice
