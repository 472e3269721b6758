#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

#include "src/experiment/perturbations.h"

namespace ricochet {
namespace {

/// Chi-square of counts that should be alike, as deviations from its mean: a normal number, about.
double excess(const std::vector<int>& counts, double expected) {
  double chi_square = 0;
  for (const int count : counts) chi_square += std::pow(count - expected, 2) / expected;
  const auto parameterisation = static_cast<double>(counts.size() - 1);
  return (chi_square - parameterisation) / std::sqrt(2 * parameterisation);
}

/// Ways to come by many numbers in [0, 1): one sequence, and the first number of keys that differ
/// as little as keys can.
const std::vector<std::function<double(int)>>& sources() {
  static const std::vector<std::function<double(int)>> all = {
      [draws = Draws(0)](int) mutable { return draws.uniform(); },
      [](int k) { return Draws(key_of(0, static_cast<std::uint64_t>(k))).uniform(); },
      [](int k) { return Draws(key_of(static_cast<std::uint64_t>(k), 0)).uniform(); },
      [](int k) {
        return Draws(key_of(1, Vector{{0.0, 1e-12 * k, 0.0}})).uniform();
      },
      [](int k) {
        return Draws(
                   key_of(1, Vector{{static_cast<double>(k % 300), static_cast<double>(k / 300)}}))
            .uniform();
      }};
  return all;
}

TEST(Draws, AreTheSequenceOfSplitMix64) {
  // The first numbers from seed 1234567, as published for tests of implementations.
  Draws draws(1234567);
  for (const std::uint64_t bits : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                   4593380528125082431U, 16408922859458223821U}) {
    EXPECT_EQ(draws.bits(), bits);
  }
}

TEST(Draws, AreUniformFromWhateverSource) {
  constexpr int size = 100'000;
  constexpr int cells = 100;
  for (auto source : sources()) {
    std::vector<int> counts(cells);
    std::array<int, 53> ones = {};
    for (int k = 0; k < size; ++k) {
      const double drawn = source(k);
      ASSERT_GE(drawn, 0);
      ASSERT_LT(drawn, 1);
      ++counts[static_cast<std::size_t>(drawn * cells)];
      const auto bits = static_cast<std::uint64_t>(std::ldexp(drawn, 53));
      for (std::size_t bit = 0; bit < ones.size(); ++bit) ones[bit] += (bits >> bit) & 1;
    }
    EXPECT_LT(std::abs(excess(counts, size / cells)), 5);
    for (const int count : ones) {
      EXPECT_LT(std::abs(2 * count - size) / std::sqrt(static_cast<double>(size)), 5);
    }
  }
}

TEST(Draws, OfNeighboursAreIndependent) {
  constexpr int size = 100'000;
  constexpr int cells = 16;
  for (auto source : sources()) {
    for (const int lag : {1, 2, 300}) {
      std::vector<double> drawn;
      for (int k = 0; k < size + lag; ++k) drawn.push_back(source(k));
      std::vector<int> counts(cells * cells);
      for (std::size_t k = 0; k < size; ++k) {
        const int x = static_cast<int>(cells * drawn[k]);
        const int y = static_cast<int>(cells * drawn[k + static_cast<std::size_t>(lag)]);
        ++counts[static_cast<std::size_t>(cells * x + y)];
      }
      EXPECT_LT(std::abs(excess(counts, static_cast<double>(size) / (cells * cells))), 5) << lag;
    }
  }
}

TEST(Draws, ChangeWithEveryBitOfTheKey) {
  for (const std::uint64_t key : {std::uint64_t{0}, std::uint64_t{1}, UINT64_MAX}) {
    double changed = 0;
    for (int bit = 0; bit < 64; ++bit) {
      const std::uint64_t other = key ^ (std::uint64_t{1} << bit);
      changed += std::popcount(Draws(key_of(key, 0)).bits() ^ Draws(key_of(other, 0)).bits());
    }
    EXPECT_NEAR(changed / 64, 32, 5 * 4 / 8.0);  // a mean of 64 numbers of deviation 4
  }
}

/// Draws of all points of a grid through the origin, where a product of coordinates would be 0 most
/// of the time.
TEST(Draws, DifferAtDifferentPointsHoweverManyCoordinatesAreZero) {
  std::set<std::uint64_t> keys;
  std::size_t points = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (int k = 0; k < 5 * 5 * 5 * 5; ++k) {
      Vector point(4);
      int rest = k;
      for (double& x : point) {
        x = 0.5 * (rest % 5 - 2);
        rest /= 5;
      }
      for (const Eigen::Index size : {3, 4}) {
        if (size == 3 && point[3] != 0) continue;  // beside it a point without the last zero
        keys.insert(key_of(seed, Vector(point.head(size))));
        ++points;
      }
    }
  }
  EXPECT_EQ(keys.size(), points);
  EXPECT_EQ(key_of(0, Vector{{0.0, -0.0}}), key_of(0, Vector{{-0.0, 0.0}}));
}

TEST(Draws, DifferByName) {
  EXPECT_NE(key_of(1, "noisy"), key_of(1, "outliers"));
  EXPECT_NE(key_of(1, "noisy"), key_of(2, "noisy"));
  EXPECT_EQ(key_of(1, "noisy"), key_of(1, "noisy"));
}

/// The largest distance between the sample's distribution and another; of n numbers beyond
/// 1.95 / sqrt(n) once in a thousand samples.
double kolmogorov(std::vector<double> sample, const std::function<double(double)>& share_below) {
  std::sort(sample.begin(), sample.end());
  double largest = 0;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(sample.size());
    largest = std::max(largest, std::abs(share - share_below(sample[k])));
  }
  return largest * std::sqrt(static_cast<double>(sample.size()));
}

TEST(Draws, AreNormal) {
  Draws draws(7);
  std::vector<double> sample(100'000);
  for (double& number : sample) number = draws.normal();
  const auto below = [](double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; };
  EXPECT_LT(kolmogorov(sample, below), 1.95);
  for (double& number : sample) number *= 1.02;
  EXPECT_GT(kolmogorov(sample, below), 1.5);
}

TEST(Draws, AreOfTheCauchyDistribution) {
  Draws draws(8);
  std::vector<double> sample(100'000);
  for (double& number : sample) number = draws.cauchy();
  const auto below = [](double x) { return 0.5 + std::atan(x) / std::numbers::pi; };
  EXPECT_LT(kolmogorov(sample, below), 1.95);
}

}  // namespace
}  // namespace ricochet
