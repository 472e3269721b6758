#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "problems/carrier_track/regimes/border.h"

namespace ricochet::carrier_track {
namespace {

/// A margin along a step of the length `step`: a cubic of t in [0, 1].
struct Cubic {
  double c0, c1, c2, c3;

  double value(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  double slope(double t) const { return c1 + t * (2 * c2 + t * 3 * c3); }
  Margin at(double t, double step) const { return {value(t), slope(t) / step}; }
  /// The least of the absolute values if it keeps its sign, else 0.
  double least() const {
    double least = std::abs(value(0));
    for (int k = 0; k <= 1000; ++k) {
      if ((value(k / 1000.0) > 0) != (value(0) > 0)) return 0;
      least = std::min(least, std::abs(value(k / 1000.0)));
    }
    return least;
  }
};

TEST(KeptSign, IsNeverSaidOfACubicThatPassesZero) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  int kept = 0;
  int passes = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Cubic cubic{number(random), number(random), number(random), number(random)};
    const double step = std::exp(3 * number(random));
    const bool said = keeps_sign(cubic.at(0, step), cubic.at(1, step), step);
    if (cubic.least() == 0) {
      ++passes;
      EXPECT_FALSE(said) << cubic.c0 << " " << cubic.c1 << " " << cubic.c2 << " " << cubic.c3;
    } else if (said) {
      ++kept;
    }
  }
  EXPECT_GT(passes, 5'000);
  EXPECT_GT(kept, 2'000);
}

TEST(KeptSign, IsSaidWhereTheMarginHardlyChanges) {
  for (const double sign : {-1.0, 1.0}) {
    const Cubic line{sign, 0.1, 0.05, -0.02};
    EXPECT_TRUE(keeps_sign(line.at(0, 0.01), line.at(1, 0.01), 0.01));
  }
}

TEST(KeptSign, IsNotSaidOfADipBelowZeroBetweenTwoMargins) {
  const Cubic dip{0.1, -1, 1, 0};  // least -0.15 in the middle
  EXPECT_FALSE(keeps_sign(dip.at(0, 0.01), dip.at(1, 0.01), 0.01));
}

}  // namespace
}  // namespace ricochet::carrier_track
