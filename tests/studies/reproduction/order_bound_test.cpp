#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ricochet/random.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

bool is_ordered(const std::vector<double>& values, const std::vector<AtMost>& order) {
  return std::all_of(order.begin(), order.end(),
                     [&](const AtMost& o) { return values[o.lower] <= values[o.upper] + 1e-12; });
}

double squared_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

double largest_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Every list of `size` numbers out of 0, 1/2, ..., 4.
std::vector<std::vector<double>> all_lists(std::size_t size) {
  if (size == 0) return {{}};
  std::vector<std::vector<double>> lists;
  for (const auto& shorter : all_lists(size - 1)) {
    for (int k = 0; k <= 8; ++k) {
      lists.push_back(shorter);
      lists.back().push_back(0.5 * k);
    }
  }
  return lists;
}

/// A random order among four: pairs by rising place, so that there is no circle.
std::vector<AtMost> random_order(Random& random) {
  std::vector<AtMost> order;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (uniform(random) < 0.5) order.push_back({i, j});
    }
  }
  return order;
}

TEST(IsotonicBound, IsThatOfAllOrderedLists) {
  const auto lists = all_lists(4);
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const std::vector<AtMost> order = random_order(random);
    std::vector<double> values(4);
    for (double& v : values) v = std::floor(5 * uniform(random));
    const OrderBound bound = isotonic_bound(values, order);
    EXPECT_TRUE(is_ordered(bound.nearest, order));
    const double nearest = squared_distance(bound.nearest, values);
    EXPECT_NEAR(bound.root_mean_square, std::sqrt(nearest / 4), 1e-12);
    double least_squares = 1e9, least_largest = 1e9;
    for (const auto& list : lists) {
      if (!is_ordered(list, order)) continue;
      least_squares = std::min(least_squares, squared_distance(list, values));
      least_largest = std::min(least_largest, largest_distance(list, values));
      // Nearest in a convex set: no other way from it leads nearer.
      double turn = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        turn += (values[i] - bound.nearest[i]) * (list[i] - bound.nearest[i]);
      }
      EXPECT_LE(turn, 1e-9);
    }
    EXPECT_LE(nearest, least_squares + 1e-9);
    EXPECT_NEAR(bound.largest, least_largest, 1e-12);  // a half of whole numbers' difference
  }
}

TEST(ConcaveBound, IsThatOfAllConcaveThresholds) {
  const std::vector<double> y = {std::log(9.0), std::log(8.0), std::log(7.3)};
  const OrderBound bound = concave_bound(y, 0.1);
  double least_squares = 1e9, least_largest = 1e9;
  constexpr int steps = 100;
  const auto near = [&](std::size_t i, int k) { return y[i] + 0.12 * (2.0 * k / steps - 1); };
  for (int a = 0; a <= steps; ++a) {
    for (int b = 0; b <= steps; ++b) {
      for (int c = 0; c <= steps; ++c) {
        const std::vector<double> list = {near(0, a), near(1, b), near(2, c)};
        if (list[1] < 0.9 * list[0] + 0.1 * list[2]) continue;
        least_squares = std::min(least_squares, squared_distance(list, y));
        least_largest = std::min(least_largest, largest_distance(list, y));
      }
    }
  }
  EXPECT_NEAR(bound.root_mean_square, std::sqrt(least_squares / 3), 0.0015);
  EXPECT_LE(bound.root_mean_square, std::sqrt(least_squares / 3) + 1e-12);
  EXPECT_NEAR(bound.largest, least_largest, 0.0025);
  EXPECT_LE(bound.largest, least_largest + 1e-12);
  EXPECT_EQ(concave_bound({1, 1, 0}, 0.5).largest, 0) << "concave";
}

/// By hand, from the paper's thresholds.
TEST(OrderBound, OfThePaperRestsOnFewOfItsThresholds) {
  report::Results results;
  add_bounds(results);
  const Table& bounds = *results.table("bounds");
  ASSERT_EQ(bounds.rows.size(), 3U);
  // C10 is above C6, of which half is each one's share.
  const double half = std::log(2.0 / 1.9) / 2;
  EXPECT_NEAR(bounds[0].number("largest"), half, 1e-12);
  EXPECT_NEAR(bounds[0].number("root_mean_square"), std::sqrt(2 * half * half / 10), 1e-12);
  // C5 is below the chord from C1 to C9.
  const double below = 0.9 * std::log(9.0) + 0.1 * std::log(7.3) - std::log(8.0);
  EXPECT_NEAR(bounds[1].number("largest"), below / 2, 1e-12);
  // The means of each machine.
  EXPECT_NEAR(bounds[2].number("largest"), std::log(9 / 7.3) / 2, 1e-12);
  double squares = 0;
  for (const std::vector<double>& machine :
       std::vector<std::vector<double>>{{9, 8, 7.3}, {2, 1.9, 2}, {13, 11.9}, {3.1, 3}}) {
    double mean = 0;
    for (const double w : machine) mean += std::log(w) / static_cast<double>(machine.size());
    for (const double w : machine) squares += std::pow(std::log(w) - mean, 2);
  }
  EXPECT_NEAR(bounds[2].number("root_mean_square"), std::sqrt(squares / 10), 1e-12);
  EXPECT_EQ(*results.value("steepest.case"), value_of("C1"));
  EXPECT_NEAR(*number_in(*results.value("steepest.share")), std::log(9.0 / 8) / std::log(9 / 7.3),
              1e-12);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
