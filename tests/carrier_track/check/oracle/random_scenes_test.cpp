#include "problems/carrier_track/check/random_scenes.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {
namespace {

TEST(RandomScenes, AreTheSameForTheSameSeedOnly) {
  RandomScenes one(7);
  RandomScenes other(7);
  RandomScenes third(8);
  for (int i = 0; i < 100; ++i) {
    const std::string scene = write_scene(one.next());
    EXPECT_EQ(scene, write_scene(other.next()));
    EXPECT_NE(scene, write_scene(third.next()));
  }
}

TEST(RandomScenes, AreValid) {
  RandomScenes scenes(1);
  for (int i = 0; i < 1000; ++i) EXPECT_NO_THROW(check(scenes.next(), "random"));
}

}  // namespace
}  // namespace ricochet::carrier_track
