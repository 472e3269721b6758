#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/certainty.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

void expect_same(const FeatureTrace& a, const FeatureTrace& b) {
  for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
    ASSERT_EQ(a.features(kind).size(), b.features(kind).size());
    for (std::size_t i = 0; i < a.features(kind).size(); ++i) {
      EXPECT_EQ(a.features(kind)[i].time, b.features(kind)[i].time);
      EXPECT_EQ(a.features(kind)[i].scaled, b.features(kind)[i].scaled);
    }
  }
}

TEST(Neighbours, AreTheSameBesideTheSceneAndAlone) {
  RandomScenes random(21);
  std::size_t features = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = random.next();
    FeatureTrace trace(scene), alone(scene);
    Neighbours beside(scene), apart(scene);
    const End<double> end = beside.simulate_with(scene, trace);
    EXPECT_EQ(end.position, simulate(scene, alone).position);
    expect_same(trace, alone);
    for (std::size_t k = 0; k < 4; ++k) {
      expect_same(beside.all()[k].trace, apart.all()[k].trace);
      features += apart.all()[k].trace.features(FeatureTrace::lower_impact).size();
    }
  }
  EXPECT_GT(features, 1000U);
}

TEST(Neighbours, LastALittleLongerThanTheScene) {
  const Scene scene = RandomScenes(22).next();
  Neighbours neighbours(scene);
  for (const Neighbour& n : neighbours.all()) {
    EXPECT_NEAR(n.end, duration_of(scene), 1e-8 * duration_of(scene));
    EXPECT_NEAR(duration_of(n.scene) / n.end, 1 + Neighbour::same_time, 1e-12);
  }
}

TEST(Neighbours, WhoseWallsCrossCannotBeSimulated) {
  Scene scene;
  scene.start_velocity = 1;
  scene.wall_lower = scene.start_position = 1.0;
  scene.wall_upper = 1.0 + 1e-13;
  Neighbours neighbours(scene);
  int failures = 0;
  for (const Neighbour& n : neighbours.all()) failures += n.failure ? 1 : 0;
  EXPECT_GT(failures, 0);
}

}  // namespace
}  // namespace ricochet::carrier_track
