#include <gmock/gmock.h>

#include <map>
#include <set>

#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {
namespace {

constexpr int draws = 60000;

/// How often so many coordinates move, and how often each does; the draws must be distinct.
struct Tally {
  std::map<std::size_t, double> of_size;
  std::map<Eigen::Index, double> of_coordinate;
};

Tally tally(Moved moved, const std::vector<Eigen::Index>& all) {
  Coordinates coordinates(all);
  Random random(1);
  Tally tally;
  for (int k = 0; k < draws; ++k) {
    const auto drawn = coordinates.draw(moved, random);
    const std::set<Eigen::Index> distinct(drawn.begin(), drawn.end());
    EXPECT_EQ(distinct.size(), drawn.size());
    tally.of_size[drawn.size()] += 1.0 / draws;
    for (const Eigen::Index i : drawn) tally.of_coordinate[i] += 1.0 / draws;
  }
  return tally;
}

void expect_shares(const Tally& tally, const std::map<std::size_t, double>& of_size,
                   double of_coordinate, const std::vector<Eigen::Index>& all) {
  ASSERT_EQ(tally.of_size.size(), of_size.size());
  for (const auto& [size, share] : of_size) EXPECT_NEAR(tally.of_size.at(size), share, 0.01);
  ASSERT_EQ(tally.of_coordinate.size(), all.size());
  for (const Eigen::Index i : all) EXPECT_NEAR(tally.of_coordinate.at(i), of_coordinate, 0.01);
}

TEST(Coordinates, AreAll) {
  expect_shares(tally(Moved::all, {0, 2, 3}), {{3, 1}}, 1, {0, 2, 3});
}

TEST(Coordinates, RoundedMayBeNone) {
  expect_shares(tally(Moved::rounded, {4}), {{0, 0.5}, {1, 0.5}}, 0.5, {4});
  expect_shares(tally(Moved::rounded, {0, 2, 3}),
                {{0, 1.0 / 6}, {1, 1.0 / 3}, {2, 1.0 / 3}, {3, 1.0 / 6}}, 0.5, {0, 2, 3});
}

TEST(Coordinates, CeiledAreAtLeastOne) {
  expect_shares(tally(Moved::ceiled, {4}), {{1, 1}}, 1, {4});
  expect_shares(tally(Moved::ceiled, {0, 2, 3}), {{1, 1.0 / 3}, {2, 1.0 / 3}, {3, 1.0 / 3}},
                2.0 / 3, {0, 2, 3});
}

TEST(Coordinates, OfCoinsAreBinomial) {
  expect_shares(tally(Moved::coins, {0, 2, 3}), {{0, 0.125}, {1, 0.375}, {2, 0.375}, {3, 0.125}},
                0.5, {0, 2, 3});
}

}  // namespace
}  // namespace ricochet::fireworks
