// Random numbers, seeds and differences.

#include "ricochet/random.h"
#include "src/core/difference.h"
#include "src/core/instance.h"
#include "tests/support/test.h"

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

TEST(Random, IsNormalAndBeginsAlikeWhateverTheSize) {
  Random random(1);
  const Vector sample = normal(10'001, random);
  EXPECT_LT(kolmogorov(sample), 1.95 / 100);
  EXPECT_GT(kolmogorov(1.1 * sample), 1.95 / 100);
  // Neighbours share a draw, but tell nothing of each other.
  EXPECT_LT(std::abs(sample.head(10'000).dot(sample.tail(10'000))) / 100, 3.3);
  Random again(1);
  EXPECT_EQ(normal(3, again), sample.head(3));
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

/// Values of the test vectors in RFC 9923.
TEST(FnvHash, HasThePublishedValues) {
  FnvHash hash;
  EXPECT_EQ(hash.value(), 0xcbf29ce484222325U);
  hash.add("foo");
  hash.add("bar");
  EXPECT_EQ(hash.value(), 0x85944171f73967e8U);
}

TEST(Seed, IsFnv1aOfTheNamesAndNumbersWithAnEndOfEach) {
  const auto hash_of = [](std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return hash;
  };
  EXPECT_EQ(seed_of("a", "b", 1, 2), hash_of("a\xFF"
                                             "b\xFF"
                                             "1\xFF"
                                             "2\xFF"));
  EXPECT_EQ(seed_of("ab", "", 12, 3, "count"), hash_of("ab\xFF\xFF"
                                                       "12\xFF"
                                                       "3\xFF"
                                                       "count\xFF"));
}

TEST(Difference, IsExactToManyDigitsOfASmoothFunction) {
  const auto two = [](double t) -> Vector { return Eigen::Vector2d(std::sin(t), std::cos(t)); };
  for (const double x : {0.3, 1.0, 2.5}) {
    const Difference slope = difference([](double t) { return std::sin(t); }, x, 0.1);
    EXPECT_NEAR(slope.slope, std::cos(x), 1e-12);
    EXPECT_LT(slope.error, 1e-11);
    const std::vector<Difference> slopes = differences(two, x, 0.1);
    ASSERT_EQ(slopes.size(), 2U);
    EXPECT_NEAR(slopes[0].slope, std::cos(x), 1e-12);
    EXPECT_NEAR(slopes[1].slope, -std::sin(x), 1e-12);
  }
}

TEST(Difference, OwnsUpToAnErrorNextToACorner) {
  const auto corner = [](double t) { return std::abs(t); };
  EXPECT_NEAR(difference(corner, 0.03, 0.1).slope, 1.0, 1e-9)
      << "the first step leads over the corner at 0 and the last does not";
  EXPECT_LT(difference(corner, 1e-6, 0.1).slope, 0.5) << "none is short enough";
}

TEST(Extrapolation, RemovesTheSquareOfTheStepOrTheStepItself) {
  Extrapolation<> extrapolation;
  extrapolation.add(3 + 7 * 1.0);
  EXPECT_TRUE(std::isinf(extrapolation.best().error));
  extrapolation.add(3 + 7 * 0.25);
  EXPECT_DOUBLE_EQ(extrapolation.best().slope, 3);
  const Difference slope = one_sided_difference([](double t) { return t * t + t; }, 2.0, 0.5);
  EXPECT_NEAR(slope.slope, 5, 1e-13);
}

}  // namespace
}  // namespace ricochet
