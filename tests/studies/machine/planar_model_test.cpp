#include <gmock/gmock.h>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/machine/answer.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using testing::HasSubstr;
using testing::StartsWith;

/// A machine whose carrier starts off its track in the middle of a clearance across.
Scene machine_with_room_across() {
  Scene scene = scene_of(find_case("C1"), default_machine());
  scene.contact_friction = false;
  scene.across.emplace();
  scene.across->wall_upper = 1e-3;
  scene.across->start_position = 5e-4;
  return scene;
}

TEST(PlanarModel, IsNotNeededWhereThereIsNoRoomAcross) {
  EXPECT_THAT(planar_sentence(scene_of(find_case("C1"), default_machine()), 8),
              HasSubstr("No: the file has no clearance across"));
}

TEST(PlanarModel, IsNotNeededWhereFrictionHoldsTheCarrier) {
  Scene scene = machine_with_room_across();
  scene.slider_mass_radius = 0;
  EXPECT_THAT(planar_sentence(scene, 8), StartsWith("No: at 8.000 rad/s friction holds"));
}

TEST(PlanarModel, IsNeededWhereAPullAcrossBeatsFriction) {
  Scene scene = machine_with_room_across();
  scene.across->pull = 10 * scene.friction * scene.normal_force;
  EXPECT_THAT(planar_sentence(scene, 8), StartsWith("Yes: at 8.000 rad/s"));
}

}  // namespace
}  // namespace ricochet::studies::advice
