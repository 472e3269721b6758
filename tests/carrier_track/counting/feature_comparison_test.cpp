#include <gtest/gtest.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/certainty.h"

namespace ricochet::carrier_track {
namespace {

TEST(FeatureComparison, IsClearOnlyIfTheOppositeChangeRaisesNoDoubtEither) {
  int clear = 0;
  int doubtful = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = hostile_scene(31, i).scene;
    const double duration = duration_of(scene);
    FeatureTrace trace(scene);
    simulate(scene, trace);
    Neighbours neighbours(scene);
    bool one_side_is_clear = true;
    bool any_doubt = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour& near = neighbours.all()[k];
      if (near.failure) {
        any_doubt = true;
        continue;
      }
      const FeatureComparison comparison(trace, duration, near.trace, near.end);
      if (k % 2 == 0) one_side_is_clear = one_side_is_clear && comparison.is_clear();
      any_doubt = any_doubt || comparison.first().doubt != Doubt::none;
    }
    if (!one_side_is_clear) continue;
    ++clear;
    EXPECT_FALSE(any_doubt);
    doubtful += any_doubt ? 1 : 0;
  }
  EXPECT_GT(clear, 1000);
  EXPECT_EQ(doubtful, 0);
}

TEST(FeatureComparison, OfASceneWithItselfIsClearOnlyFarFromALimit) {
  Scene scene;  // one impact
  scene.restitution_lower = scene.restitution_upper = 0;
  scene.friction = 0;
  scene.start_velocity = 1;
  scene.wall_upper = 1;
  scene.start_position = 0.5;
  scene.window = Seconds{1};
  for (const double share : {0.5, 1 - 1e-12, 1 - 1e-6}) {
    SCOPED_TRACE(share);
    scene.counting_limit = share;
    FeatureTrace trace(scene);
    simulate(scene, trace);
    const FeatureComparison comparison(trace, 1, trace, 1);
    EXPECT_EQ(comparison.first().doubt == Doubt::none, share < 1 - 1e-9);
    EXPECT_EQ(comparison.is_clear(), share < 1 - 1e-7);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
