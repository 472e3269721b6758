#include <gtest/gtest.h>

#include <stdexcept>

#include "src/analysis/statistics/break_even.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

TEST(VirtualBest, IsTheLeastOfEachProblem) {
  EXPECT_EQ(virtual_best({{3, 2}, {infinity, 7}, {infinity, infinity}}),
            (std::vector<double>{2, 7, infinity}));
  EXPECT_THROW(virtual_best({}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
