#include "tests/carrier_track/models/planar_brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr double counting_limit = 1e-6;  // [m/s]; see brute_force_test.cpp

TEST(PlanarBruteForce, BruteForceFindsTheImpactsOfRandomScenes) {
  RandomScenes scenes(41);
  std::size_t listed = 0;
  std::size_t compared = 0;
  int certain = 0;
  std::vector<double> errors;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next_planar();
    const Recording model = record(scene, 0.25, 0);
    // The difference of two steps is by theory fifteen times the error of the finer one: the bar.
    const BruteForce fine = planar_brute_force(scene, 1e-5);
    const std::vector<Impact> reference = faster(fine.impacts, counting_limit);
    const std::vector<Impact> coarse =
        faster(planar_brute_force(scene, 4e-5).impacts, counting_limit);
    const std::vector<Impact> actual = faster(model.impacts, counting_limit);
    double time_bar = 1e-8;
    double speed_bar = 1e-8;
    std::size_t k = 0;
    for (; k < std::min(reference.size(), coarse.size()); ++k) {
      const double difference = std::abs(reference[k].time - coarse[k].time);
      if (reference[k].wall != coarse[k].wall || difference > 1e-4) break;
      time_bar = std::max(time_bar, difference);
      speed_bar = std::max(speed_bar, std::abs(reference[k].speed - coarse[k].speed));
      ASSERT_LT(k, actual.size()) << "an impact is missing";
      ASSERT_EQ(actual[k].wall, reference[k].wall) << "impact " << k;
      ASSERT_NEAR(actual[k].time, reference[k].time, time_bar) << "impact " << k;
      ASSERT_NEAR(actual[k].speed, reference[k].speed, speed_bar) << "impact " << k;
      errors.push_back(std::abs(actual[k].time - reference[k].time));
    }
    if (k == reference.size() && k == coarse.size()) {
      EXPECT_EQ(actual.size(), k) << "an impact too many";
      EXPECT_NEAR(model.end.position, fine.position, 1e-6);
    }
    listed += reference.size();
    compared += k;
    if (!model.certainty.certain) continue;
    ++certain;
    EXPECT_EQ(model.count, std::ssize(faster(fine.impacts, scene.counting_limit)));
  }
  std::sort(errors.begin(), errors.end());
  RecordProperty("impacts", std::to_string(listed));
  RecordProperty("compared", std::to_string(compared));
  RecordProperty("median_ns", std::to_string(1e9 * errors[errors.size() / 2]));
  RecordProperty("0.9_quantile_ns", std::to_string(1e9 * errors[errors.size() * 9 / 10]));
  RecordProperty("certain", std::to_string(certain));
  EXPECT_GT(listed, 1000U);
  EXPECT_GT(compared, listed * 95 / 100);
  EXPECT_GT(certain, 95);
}

}  // namespace
}  // namespace ricochet::carrier_track
