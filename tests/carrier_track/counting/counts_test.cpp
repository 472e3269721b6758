#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

std::vector<int> one_by_one(const Scene& scene, const std::vector<double>& speeds) {
  std::vector<int> counts;
  for (const double omega : speeds) counts.push_back(count_at(scene, omega));
  return counts;
}

const std::vector<double> speeds{0.4, 1, 1.001, 1.002, 3, 7.5, 18};

TEST(Counts, AreThoseOfSingleSimulations) {
  RandomScenes random(5);
  for (int i = 0; i < 200; ++i) {
    const Scene scene = random.next();
    EXPECT_EQ(counts_at(scene, speeds), one_by_one(scene, speeds)) << i;
  }
}

TEST(Counts, AreThoseOfSingleSimulationsUnderOtherRulesAndModels) {
  RandomScenes random(6);
  for (int i = 0; i < 20; ++i) {
    Scene scene = random.next();
    scene.rule = CountRule::peaks;
    EXPECT_EQ(counts_at(scene, speeds), one_by_one(scene, speeds)) << i;
    const Scene planar = random.next_planar();
    EXPECT_EQ(counts_at(planar, speeds), one_by_one(planar, speeds)) << i;
  }
}

TEST(Counts, AskWhetherAnImpactIsFasterThanTheSlowestAsTheLogarithmDoes) {
  // An elastic body keeps its speed: at the limit, and an ulp beside it.
  for (const double speed : {0.1, 0.7, 1.9, std::nextafter(2.0, 0.0)}) {
    for (const double counting_limit :
         {std::nextafter(speed, 0.0), speed, std::nextafter(speed, 9.0)}) {
      Scene scene;
      scene.start_velocity = speed;
      scene.counting_limit = counting_limit;
      scene.window = Seconds{10};
      const std::vector<double> one{1.0};
      EXPECT_EQ(counts_at(scene, one), one_by_one(scene, one)) << speed << ' ' << counting_limit;
    }
  }
}

TEST(Counts, AndSurrogatesOfManyScenesAreThoseOfEach) {
  RandomScenes random(7);
  std::vector<Scene> scenes(50);
  for (Scene& scene : scenes) scene = random.next();
  for (const double smoothing : {0.0, 0.25}) {
    const std::vector<double> results = objectives(scenes, smoothing);
    ASSERT_EQ(results.size(), scenes.size());
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      EXPECT_EQ(results[k], objective(scenes[k], smoothing)) << k;
    }
  }
}

TEST(Counts, OfAnInvalidSceneOrSpeedAreRefused) {
  Scene scene = RandomScenes(8).next();
  EXPECT_EQ(counts(scene, speeds), counts_at(scene, speeds));
  EXPECT_THROW(counts(scene, std::vector<double>{1.0, -1.0}), InputError);
  EXPECT_THROW(counts(scene, std::vector<double>{std::nan("")}), InputError);
  scene.wall_upper = scene.wall_lower;
  EXPECT_THROW(counts(scene, speeds), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
