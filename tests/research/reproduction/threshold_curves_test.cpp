#include "src/research/reproduction/threshold_curves.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/regimes.h"
#include "ricochet/threshold.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

TEST(ThresholdCurves, MeetThePapersCases) {
  const Scene interpretation = default_interpretation().scene;
  const auto curves = threshold_curves(all_cases(), interpretation, 36, fastest_speed);
  ASSERT_EQ(curves.size(), 6U);  // two frictions, three disturbances
  int met = 0;
  for (const Case& c : all_cases()) {
    const auto expected =
        quiet_up_to(scene_of(c, interpretation), quiet_per_turn, {slowest_speed, fastest_speed});
    for (const ThresholdCurve& curve : curves) {
      if (curve.friction != c.friction || curve.disturbance != c.disturbance) continue;
      for (const CurvePoint& point : curve.points) {
        if (point.restitution != c.restitution) continue;
        EXPECT_EQ(point.speed, expected) << c.id;
        ++met;
      }
    }
  }
  EXPECT_EQ(met, 12);
}

TEST(ThresholdCurves, FallWithRestitution) {
  for (const auto& curve :
       threshold_curves({find_case("C3")}, default_interpretation().scene, 9, fastest_speed)) {
    EXPECT_EQ(curve.points.front().restitution, 0.05);
    EXPECT_EQ(curve.points.back().restitution, 0.95);
    EXPECT_FALSE(curve.points.front().speed) << "quiet at every speed tried";
    for (std::size_t i = 2; i < curve.points.size(); ++i) {
      EXPECT_LT(curve.points[i].speed, curve.points[i - 1].speed);
    }
  }
}

TEST(ThresholdCurves, SayWhatRestitutionAndDisturbanceDo) {
  const std::vector<ThresholdCurve> curves = {{0.1, 0, {{0.1, 8}, {0.5, 4}, {0.9, 2}}},
                                              {0.1, 1, {{0.1, 6}, {0.5, 3.8}, {0.9, 1}}},
                                              {0.4, 0, {{0.1, 10}, {0.5, {}}, {0.9, 5}}}};
  const report::Json data = threshold_curve_data(curves);
  EXPECT_EQ(data["least_gain"], 2);
  EXPECT_EQ(data["most_gain"], 6);
  EXPECT_EQ(data["most_loss"], 0.5);
  EXPECT_EQ(data["largest_disturbance"], 1);
  EXPECT_TRUE(threshold_curve_data({}).is_null());
}

}  // namespace
}  // namespace ricochet::studies::reproduction
