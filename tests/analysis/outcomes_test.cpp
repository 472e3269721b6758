#include "src/analysis/outcomes.h"

#include <gtest/gtest.h>

#include <vector>

namespace ricochet::comparison {
namespace {

Outcomes numbered(int count) {
  std::vector<Outcome> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)].instance = i;
  return all;
}

std::vector<int> instances_of(const Outcomes& outcomes) {
  std::vector<int> instances;
  for (const Outcome& outcome : outcomes) instances.push_back(outcome.instance);
  return instances;
}

TEST(Outcomes, AreEveryOneOfThem) {
  EXPECT_TRUE(Outcomes().empty());
  EXPECT_EQ(instances_of(Outcomes()), std::vector<int>());
  EXPECT_EQ(instances_of(numbered(3)), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(numbered(3).size(), 3U);
}

TEST(Outcomes, AreEveryKthOfThemAndOfThose) {
  const Outcomes all = numbered(12);
  const Outcomes second_seeds = all.every(3, 1, 4);
  EXPECT_EQ(instances_of(second_seeds), (std::vector<int>{1, 4, 7, 10}));
  EXPECT_EQ(instances_of(second_seeds.every(2, 1, 2)), (std::vector<int>{4, 10}));
  EXPECT_EQ(second_seeds.front().instance, 1);
  EXPECT_EQ(second_seeds[2].instance, 7);
}

TEST(Outcomes, AreSharedByCopiesThatOutliveThem) {
  Outcomes part;
  {
    const Outcomes all = numbered(4);
    part = all.every(2, 0, 2);
    EXPECT_EQ(&part[1], &all[2]);
  }
  EXPECT_EQ(instances_of(part), (std::vector<int>{0, 2}));
}

}  // namespace
}  // namespace ricochet::comparison
