#include <gtest/gtest.h>

#include <vector>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(RandomSearch, BeginsAtTheStartAndThenFillsTheBoxEvenly) {
  std::vector<Vector> asked;
  const Problem problem = box_problem("recorded", 2, -4, 12, 1, [&asked](const Vector& x) {
    asked.push_back(x);
    return 0.0;
  });
  run(problem, random_search(), {4001}, 0);
  ASSERT_EQ(asked.size(), 4001U);
  EXPECT_EQ(asked.front(), problem.start);
  Eigen::Matrix4i tally = Eigen::Matrix4i::Zero();  // 16 cells of 4 x 4
  for (std::size_t k = 1; k < asked.size(); ++k) {
    const Vector cell = ((asked[k].array() + 4) / 4).floor();
    ++tally(static_cast<int>(cell[0]), static_cast<int>(cell[1]));
  }
  // 250 expected in each, give or take five standard deviations of 15.3.
  EXPECT_GT(tally.minCoeff(), 250 - 77);
  EXPECT_LT(tally.maxCoeff(), 250 + 77);
}

}  // namespace
}  // namespace ricochet
