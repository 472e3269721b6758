#include "src/live/count_there.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"

namespace ricochet::live {
namespace {

using namespace carrier_track;

TEST(CountThere, IsTheObjective) {
  RandomScenes random(8);
  int collisions = 0;
  for (int k = 0; k < 500; ++k) {
    Scene scene = random.next();
    if (k % 5 == 0) scene.rule = CountRule::peaks;
    const int count = count_there(scene);
    EXPECT_EQ(count, objective(scene, 0.0));
    collisions += count;
  }
  EXPECT_GT(collisions, 2000);
}

}  // namespace
}  // namespace ricochet::live
