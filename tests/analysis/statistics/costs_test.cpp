#include <gtest/gtest.h>

#include <stdexcept>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {
namespace {

TEST(Costs, OfAPairAreThoseOfBothInTheOrderAsked) {
  EXPECT_EQ(check_costs({{1, 2, 3}, {4, 5, 6}}), 3U);
  EXPECT_EQ(costs_of_pair({{1, 2, 3}, {4, 5, 6}}, 2, 0), (Costs{{3, 1}, {6, 4}}));
  EXPECT_THROW(costs_of_pair({{1, 2, 3}}, 0, 3), std::invalid_argument);
  EXPECT_THROW(check_costs({{1, -2}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
