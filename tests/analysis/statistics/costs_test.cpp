#include <gtest/gtest.h>

#include <stdexcept>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {
namespace {

TEST(Costs, AreOfAsManySolversForEachProblem) {
  EXPECT_EQ(check_costs({{1, 2, 3}, {4, 5, 6}}), 3U);
  EXPECT_THROW(check_costs({{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(check_costs({{1, -2}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
