#include "problems/carrier_track/models/simulate.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/paper/cases.h"
#include "tests/carrier_track/questions/exploratory_scene.h"

namespace ricochet::carrier_track {
namespace {

Scene compliant(double stiffness) {
  Scene scene = scene_of(find_case("C4"), exploratory_scene());
  scene.omega = 5;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  return scene;
}

TEST(Simulate, FollowsTheFidelityOfTheScene) {
  Scene hard = compliant(1e18);
  hard.fidelity = Fidelity::impact;
  const int count = record(hard, 0.25, 0).count;
  EXPECT_EQ(record(compliant(1e18), 0.25, 0).count, count);
  EXPECT_NE(record(compliant(1e8), 0.25, 0).count, count) << "a soft wall is another machine";
}

TEST(Simulate, RecordsThePathInACompliantWall) {
  const Recording recording = record(compliant(1e10), 0.25, 200);
  double deepest = 0;
  double last = 0;
  for (const Sample& s : recording.path) {
    deepest = std::min(deepest, s.position);
    EXPECT_GE(s.time, last - 1e-12);
    last = s.time;
  }
  EXPECT_LT(deepest, -1e-6);
}

TEST(Simulate, RefusesASceneThatLeavesItsLevelOpen) {
  Scene open = compliant(1e10);
  open.fidelity = Fidelity::automatic;
  Observer nobody;
  EXPECT_THROW(simulate(open, nobody), std::invalid_argument);
  open.profile = {{0.0, 2.0}};
  EXPECT_THROW(simulate(open, nobody), std::invalid_argument);
}

TEST(Simulate, HasNoDerivativesInACompliantWall) {
  EXPECT_THROW(surrogate_slope(compliant(1e8), 0.25), std::invalid_argument);
}

/// Pressed across by the pull's other part, which adds to the normal force.
Scene planar(double pull) {
  Scene scene = compliant(1e8);
  scene.fidelity = Fidelity::planar;
  scene.across.emplace().pull = pull;
  scene.across->start_position = 1;
  return scene;
}

TEST(Simulate, MovesInTwoDirectionsAtFidelityPlanar) {
  Scene alone = planar(0);
  alone.fidelity = Fidelity::impact;
  const int count = record(alone, 0.25, 0).count;
  EXPECT_EQ(record(planar(0), 0.25, 0).count, count);
  alone.normal_force += 1.5;
  EXPECT_EQ(record(planar(1.5), 0.25, 0).count, record(alone, 0.25, 0).count);
  EXPECT_NE(record(planar(1.5), 0.25, 0).count, count);
}

TEST(Simulate, HasNoDerivativesInTwoDirections) {
  EXPECT_THROW(surrogate_slope(planar(1), 0.25), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
