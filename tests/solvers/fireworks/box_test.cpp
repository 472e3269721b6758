#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {
namespace {

double brought_back(double x, double lower, double upper) {
  Vector point = Vector::Constant(1, x);
  Random random;
  Box(Vector::Constant(1, lower), Vector::Constant(1, upper))
      .bring_back(point, Mapping::modulo, random);
  return point[0];
}

TEST(Box, BringsBackByTheModuloOnlyWhatIsOutside) {
  EXPECT_EQ(brought_back(-3, -100, 100), -3);
  EXPECT_EQ(brought_back(-100, -100, 100), -100);
  EXPECT_EQ(brought_back(100, -100, 100), 100);
  EXPECT_EQ(brought_back(130, -100, 100), 30);
  EXPECT_EQ(brought_back(-130, -100, 100), 30);
  EXPECT_EQ(brought_back(18.5, 0, 18), 0.5);
  EXPECT_EQ(brought_back(-0.5, 0, 18), 0.5);
  EXPECT_EQ(brought_back(-7, 2, 10), 9);
  EXPECT_EQ(brought_back(5, 4, 4), 4);
}

TEST(Box, ThrowsWhatIsJustOutsideSymmetricEndsNearTheOrigin) {
  EXPECT_NEAR(brought_back(100.001, -100, 100), 0.001, 1e-9);
  EXPECT_NEAR(brought_back(-100.001, -100, 100), 0.001, 1e-9);
}

TEST(Box, HoldsWhateverIsBroughtBack) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double scale = std::exp(40 * uniform(random) - 20);
    const Vector lower = scale * normal(3, random);
    Vector smoothing = scale * normal(3, random).cwiseAbs();
    smoothing[1] = 0;
    const Box box(lower, lower + smoothing);
    const Vector x = lower + 3 * scale * normal(3, random);
    for (const Mapping mapping : {Mapping::modulo, Mapping::redraw}) {
      Vector back = x;
      box.bring_back(back, mapping, random);
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(back[k], box.lower()[k]);
        ASSERT_LE(back[k], box.upper()[k]);
        if (x[k] >= box.lower()[k] && x[k] <= box.upper()[k]) {
          ASSERT_EQ(back[k], x[k]);
        }
      }
    }
  }
}

TEST(Box, RedrawsNearACentre) {
  Random random(1);
  const Box box(Vector{{2, -1}}, Vector{{6, 1}});
  double least = 6, most = 2;
  for (int trial = 0; trial < 1000; ++trial) {
    Vector x{{7, 0.5}};
    box.bring_near(x, Vector{{5, 0}}, 0.5, random);
    EXPECT_EQ(x[1], 0.5);
    least = std::min(least, x[0]);
    most = std::max(most, x[0]);
  }
  EXPECT_GE(least, 3);  // half a width from the centre
  EXPECT_LT(least, 3.1);
  EXPECT_LE(most, 6);
  EXPECT_GT(most, 5.9);
}

TEST(Box, RedrawsUniformly) {
  const Box box(Vector{{2, -1}}, Vector{{6, 1}});
  Random random(1);
  Vector sum = Vector::Zero(2), squares = Vector::Zero(2);
  constexpr int draws = 20000;
  for (int k = 0; k < draws; ++k) {
    Vector x{{7, 0.5}};
    box.bring_back(x, Mapping::redraw, random);
    ASSERT_EQ(x[1], 0.5) << "it was inside";
    box.draw(x, random);
    sum += x;
    squares += x.cwiseAbs2();
  }
  const Vector mean = sum / draws;
  const Vector variance = squares / draws - mean.cwiseAbs2();
  EXPECT_NEAR(mean[0], 4, 0.05);
  EXPECT_NEAR(mean[1], 0, 0.025);
  EXPECT_NEAR(variance[0], 16.0 / 12, 0.05);
  EXPECT_NEAR(variance[1], 4.0 / 12, 0.0125);
}

TEST(Box, HasFreeCoordinatesWhereItHasWidth) {
  EXPECT_THAT(Box(Vector{{0, 1, 2}}, Vector{{1, 1, 3}}).free(), testing::ElementsAre(0, 2));
}

}  // namespace
}  // namespace ricochet::fireworks
