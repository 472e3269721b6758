#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "solvers/scaled_box.h"

namespace ricochet {
namespace {

Vector two(double a, double b) {
  Vector v(2);
  v << a, b;
  return v;
}

/// Schaffer's first problem: the squared distances from 0 and from 2, on -10..10. Together best are
/// the points between: sqrt(f1) + sqrt(f2) = 2.
SeveralGoals schaffer() {
  return {1, 2, [](const Vector& u) {
            const double x = 20 * u[0] - 10;
            return two(x * x, (x - 2) * (x - 2));
          }};
}

/// ZDT1 (Zitzler, Deb and Thiele, Evol. Comput. 8 (2000) 173-195): best is f2 = 1 - sqrt(f1), which
/// below (1, 1) dominates 2/3.
SeveralGoals zdt1(Eigen::Index n) {
  return {n, 2, [n](const Vector& u) {
            const double g = 1 + 9 * u.tail(n - 1).sum() / static_cast<double>(n - 1);
            return two(u[0], g * (1 - std::sqrt(u[0] / g)));
          }};
}

Front some_front(std::uint64_t seed) {
  return nsga2_front(schaffer(), {20, 30, seed, {}});
}

TEST(Dominance, IsNowhereWorseAndSomewhereBetter) {
  EXPECT_TRUE(dominates(two(1, 2), two(1, 3)));
  EXPECT_TRUE(dominates(two(0, 2), two(1, 3)));
  EXPECT_FALSE(dominates(two(1, 2), two(1, 2)));
  EXPECT_FALSE(dominates(two(0, 4), two(1, 3)));
}

TEST(Front, HoldsWhatNothingDominatesWhateverTheOrder) {
  Random random(1);
  std::vector<FrontPoint> all;
  Front front;
  for (int k = 0; k < 300; ++k) {
    Vector goals(3);
    for (double& goal : goals) goal = std::floor(10 * uniform(random));
    all.push_back({{}, goals});
    add(front, all.back());
  }
  for (const FrontPoint& point : all) {
    bool dominated = false;
    for (const FrontPoint& other : all) dominated |= dominates(other.goals, point.goals);
    int times = 0;
    for (const FrontPoint& kept : front) times += kept.goals == point.goals ? 1 : 0;
    EXPECT_EQ(times, dominated ? 0 : 1) << point.goals.transpose();
  }
}

TEST(Nsga2Front, FindsTheFrontOfSchaffer) {
  const Front front = some_front(1);
  EXPECT_GT(front.size(), 15U);
  double lowest = 4, highest = 0;
  for (const FrontPoint& point : front) {
    EXPECT_NEAR(std::sqrt(point.goals[0]) + std::sqrt(point.goals[1]), 2, 0.01);
    EXPECT_EQ(schaffer().evaluate(point.u), point.goals);
    lowest = std::min(lowest, point.goals[0]);
    highest = std::max(highest, point.goals[0]);
  }
  EXPECT_LT(lowest, 0.05);
  EXPECT_GT(highest, 3.5);
}

TEST(Nsga2Front, DominatesNearlyWhatTheFrontOfZdt1Does) {
  const Front front = nsga2_front(zdt1(5), {80, 100, 1, {}});
  const double volume = hypervolume(front, two(1, 1));
  EXPECT_LT(volume, 2.0 / 3);
  EXPECT_GT(volume, 0.65);
}

TEST(Nsga2Front, IsTheSameFromTheSameSeed) {
  const Front one = some_front(1), again = some_front(1), other = some_front(2);
  ASSERT_EQ(one.size(), again.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].u, again[k].u);
  EXPECT_NE(one.front().u, other.front().u);
}

TEST(Nsga2Front, BeginsWithItsStartsAndAsksForAsMuchAsItSays) {
  std::vector<Vector> asked;
  SeveralGoals watched = zdt1(3);
  watched.evaluate = [&, inner = watched.evaluate](const Vector& u) {
    asked.push_back(u);
    return inner(u);
  };
  const Vector start = Vector::Constant(3, 0.25);
  nsga2_front(watched, {12, 5, 1, {start, 2 * start}});
  EXPECT_EQ(asked.size(), 12U * 6);
  EXPECT_EQ(asked[0], start);
  EXPECT_EQ(asked[1], 2 * start);
  for (const Vector& u : asked) {
    EXPECT_GE(u.minCoeff(), 0);
    EXPECT_LE(u.maxCoeff(), 1);
  }
}

TEST(Nsga2Front, PassesOnWhatTheGoalsThrow) {
  const SeveralGoals broken{2, 2, [](const Vector&) -> Vector { throw std::domain_error("no"); }};
  EXPECT_THROW(nsga2_front(broken, {8, 1, 1, {}}), std::domain_error);
}

TEST(Hypervolume, IsTheAreaOfStairs) {
  const Front stairs = {{{}, two(0, 2)}, {{}, two(1, 1)}, {{}, two(5, 0)}};
  EXPECT_DOUBLE_EQ(hypervolume(stairs, two(3, 3)), 3 * 1 + 2 * 1);  // the last is beyond
  EXPECT_EQ(hypervolume({}, two(1, 1)), 0);
}

}  // namespace
}  // namespace ricochet
