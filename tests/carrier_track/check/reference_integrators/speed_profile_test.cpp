#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/accuracy.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(SpeedProfile, IsFollowedAsByShortStepsAndByAdamsMoulton) {
  // All terms of equation (31), knots with and without a change of slope, sticking and Zeno ends.
  RandomScenes draws(71);
  int compared = 0;
  int timed = 0;
  int impacts = 0;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    Scene scene = draws.next();
    const double omega = scene.omega;
    double time = draws.within(0, 0.2);
    for (int k = 0; k < 5; ++k) {
      scene.profile.push_back({time, omega * draws.within(0.2, 2)});
      time += draws.within(0.05, 0.3);
    }
    scene.window = Seconds{draws.within(0.3, 1.5)};
    const Certainty certainty = record(scene, default_smoothing, 0).certainty;
    if (certainty.growth > 100 || certainty.margin.value_or(1) < 0.02) continue;
    const Outcome exact = run(find_integrator("event-driven"), scene, 0);
    const Outcome stepped = run(find_integrator("semi-implicit-euler"), scene, 1e-5);
    EXPECT_EQ(collisions(scene, stepped), collisions(scene, exact));
    EXPECT_NEAR(stepped.end.position, exact.end.position, 2e-4);
    ++compared;
    // The peers look for a departure at samples, and may miss a short one at a knot.
    const Outcome smooth = run(find_integrator("cvode-adams"), scene, 1e-12);
    const Accuracy accuracy = compare(scene, smooth, exact);
    if (accuracy.missed + accuracy.spurious > 0) continue;
    EXPECT_LT(accuracy.impact_time_error.value_or(0.0), 1e-7);
    impacts += accuracy.matched;
    ++timed;
  }
  EXPECT_GT(compared, 60);
  EXPECT_GE(timed, compared * 95 / 100);
  EXPECT_GT(impacts, 250);
}

}  // namespace
}  // namespace ricochet::carrier_track
