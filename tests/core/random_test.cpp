#include "ricochet/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

TEST(Random, IsUniformByTheGeneratorsBitsAlone) {
  Random bits(3), random(3);
  for (int k = 0; k < 1000; ++k) {
    const double drawn = uniform(random);
    EXPECT_NEAR(drawn, std::ldexp(static_cast<double>(bits()), -64), 0x1p-53);
    EXPECT_GE(drawn, 0);
    EXPECT_LT(drawn, 1);
  }
}

/// The largest distance of the sample's distribution from the normal one; of n numbers beyond
/// 1.95 / sqrt(n) once in a thousand samples.
double kolmogorov(Vector sample) {
  std::sort(sample.begin(), sample.end());
  double largest = 0;
  for (Eigen::Index k = 0; k < sample.size(); ++k) {
    const double normal_share = std::erfc(-sample[k] / std::sqrt(2.0)) / 2;
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(sample.size());
    largest = std::max(largest, std::abs(share - normal_share));
  }
  return largest;
}

TEST(Random, IsNormal) {
  Random random(1);
  const Vector sample = normal(10'001, random);
  EXPECT_LT(kolmogorov(sample), 1.95 / 100);
  EXPECT_GT(kolmogorov(1.1 * sample), 1.95 / 100);
  double together = 0;  // neighbours share a draw, but tell nothing of each other
  for (Eigen::Index k = 1; k < sample.size(); ++k) together += sample[k] * sample[k - 1];
  EXPECT_LT(std::abs(together) / 100, 3.3);
}

TEST(Random, TurnsUniformly) {
  // Every column is uniform on the sphere, so that each entry is uniform in -1 to 1 (Archimedes).
  Random random(2);
  constexpr int size = 10'000;
  double mean = 0, square = 0, product = 0;
  for (int k = 0; k < size; ++k) {
    const Matrix turn = random_turn(3, random);
    EXPECT_LT((turn.transpose() * turn - Matrix::Identity(3, 3)).norm(), 1e-14);
    mean += turn(0, 2) / size;
    square += turn(0, 2) * turn(0, 2) / size;
    product += turn(0, 2) * turn(1, 1) / size;
  }
  EXPECT_LT(std::abs(mean), 5 * std::sqrt(1.0 / 3 / size));
  EXPECT_NEAR(square, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / size));
  EXPECT_LT(std::abs(product), 5 * std::sqrt(1.0 / 3 / size));
}

TEST(Random, BeginsAlikeWhateverTheSize) {
  Random one(5), other(5);
  EXPECT_EQ(normal(3, one), normal(8, other).head(3));
}

}  // namespace
}  // namespace ricochet
