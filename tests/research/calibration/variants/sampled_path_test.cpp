#include "src/research/calibration/variants/sampled_path.h"

#include <gtest/gtest.h>

#include "src/research/calibration/variants/changed_motion.h"

namespace ricochet::studies::variants {
namespace {

/// Falls 1 m in 1 s, hits the ground at 2 m/s and rises at 1 m/s.
carrier_track::Scene falling_body() {
  carrier_track::Scene scene;
  scene.mass = 1;
  scene.pull = 2;
  scene.wall_upper = 10;
  scene.start_position = 1;
  scene.restitution_lower = 0.5;
  scene.window = carrier_track::Seconds{1.5};
  return scene;
}

TEST(SampledPath, IsThePathAtTheMultiplesOfItsStep) {
  const auto scene = falling_body();
  SampledPath path(0.1);
  const MotionChange nothing;
  ChangedMotion(scene, nothing, carrier_track::resting_speed).run(path);
  const auto& x = path.samples();
  ASSERT_GE(x.size(), 15U);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double t = 0.1 * static_cast<double>(k);
    const double up = t - 1;
    EXPECT_NEAR(x[k], t <= 1 ? 1 - t * t : up - up * up, 1e-12) << t;
  }
}

TEST(SampledPath, OfALongRestIsOnePlateauToTheLastBit) {
  auto scene = falling_body();
  scene.restitution_lower = 0;
  SampledPath path(0.05);
  const MotionChange nothing;
  ChangedMotion(scene, nothing, carrier_track::resting_speed).run(path);
  ASSERT_GT(path.samples().size(), 25U);
  for (std::size_t k = 21; k < path.samples().size(); ++k) EXPECT_EQ(path.samples()[k], 0);
}

}  // namespace
}  // namespace ricochet::studies::variants
