#include "src/studies/reproduction/threshold_curves.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

std::vector<ThresholdCurve> curves_of(const std::vector<Case>& cases, bool coarse) {
  return threshold_curves(cases, default_interpretation().scene, coarse, fastest_speed);
}

/// Expects that the case's threshold is on the curve of its friction and disturbance.
void expect_on(const std::vector<ThresholdCurve>& curves, const Case& c) {
  const auto expected = quiet_up_to(scene_of(c, default_interpretation().scene), quiet_per_turn,
                                    {slowest_speed, fastest_speed});
  int met = 0;
  for (const ThresholdCurve& curve : curves) {
    if (curve.friction != c.friction || curve.disturbance != c.disturbance) continue;
    for (const CurvePoint& point : curve.points) {
      if (point.restitution != c.restitution) continue;
      EXPECT_EQ(point.speed, expected) << c.id;
      ++met;
    }
  }
  EXPECT_EQ(met, 1) << c.id;
}

TEST(ThresholdCurves, MeetThePapersCases) {
  std::vector<Case> undisturbed;
  for (const char* id : {"C1", "C2", "C3", "C4"}) undisturbed.push_back(find_case(id));
  const auto curves = curves_of(undisturbed, false);
  EXPECT_EQ(curves.size(), 2U);  // frictions
  for (const Case& c : undisturbed) expect_on(curves, c);
  expect_on(curves_of({find_case("C9")}, false), find_case("C9"));
}

TEST(ThresholdCurves, FallWithRestitution) {
  const auto curves = curves_of({find_case("C3"), find_case("C9")}, true);
  ASSERT_EQ(curves.size(), 2U) << "coarse ones have no disturbance";
  for (const ThresholdCurve& curve : curves) {
    EXPECT_EQ(curve.disturbance, 0);
    EXPECT_EQ(curve.points.front().restitution, 0.05);
    EXPECT_EQ(curve.points.back().restitution, 0.95);
    for (std::size_t i = 2; i < curve.points.size(); ++i) {
      EXPECT_LT(curve.points[i].speed, curve.points[i - 1].speed);
    }
  }
  EXPECT_FALSE(curves[1].points.front().speed) << "friction 0.4: quiet at every speed tried";
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
