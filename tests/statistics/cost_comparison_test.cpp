#include "src/statistics/cost_comparison.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/core/infinity.h"

namespace ricochet {
namespace {

TEST(CostComparison, CountsEachQuestionOnce) {
  const std::vector<double> a = {100, 100, 100, 100, 5, infinity, infinity, 1};
  const std::vector<double> b = {100, 110, 111, 90, infinity, 5, infinity, 1.05};
  const CostComparison one = compare_costs(a, b);
  EXPECT_EQ(one.better, 2);  // 100 : 111, 5 : never
  EXPECT_EQ(one.close, 3);   // 100 : 100, 100 : 110, 1 : 1.05
  EXPECT_EQ(one.worse, 2);   // 100 : 90, never : 5
  EXPECT_EQ(one.neither, 1);
  const CostComparison other = compare_costs(b, a);
  EXPECT_EQ(other.better, one.worse);
  EXPECT_EQ(other.close, one.close);
}

TEST(CostComparison, RefusesWhatDoesNotFit) {
  EXPECT_THROW(compare_costs({1}, {}), std::invalid_argument);
  EXPECT_THROW(compare_costs({1}, {0}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
