#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/motion/event.h"

namespace ricochet::carrier_track {
namespace {

TEST(ZenoTail, IsTheSumOfItsHops) {
  for (const double e : {0.0, 0.1, 0.5, 0.99}) {
    for (const double friction : {0.0, 0.7, 1.9}) {
      const double press = 2.0;
      double sum = 0;
      for (double speed = 3e-9; speed > 1e-30;) {
        const double up = speed / (press + friction);
        const double height = speed * up / 2;
        const double down = std::sqrt(2 * height / (press - friction));
        sum += up + down;
        speed = e * (press - friction) * down;
      }
      EXPECT_NEAR(zeno_tail(3e-9, e, press, friction), sum, 1e-12 * sum);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
