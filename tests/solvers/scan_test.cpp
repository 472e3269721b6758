#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(VanDerCorput, MirrorsTheBinaryDigits) {
  const std::vector<double> first = {0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875, 0.0625};
  for (std::uint64_t k = 0; k < first.size(); ++k) EXPECT_EQ(van_der_corput(k), first[k]);
}

TEST(Scan, IsAnEvenGridAfterAPowerOfTwoAndOneEvaluations) {
  std::vector<double> asked;
  const Problem problem = box_problem("recorded", 1, 2, 18, 9, [&asked](const Vector& x) {
    asked.push_back(x[0]);
    return 0.0;
  });
  run(problem, scan(), {17}, 0);
  std::sort(asked.begin(), asked.end());
  ASSERT_EQ(asked.size(), 17U);
  for (std::size_t k = 0; k < 17; ++k) EXPECT_EQ(asked[k], 2.0 + static_cast<double>(k));
}

TEST(Scan, TakesOneDimensionOnly) {
  EXPECT_TRUE(scan().accepts(staircase()));
  EXPECT_FALSE(scan().accepts(sphere(2, 3)));
}

}  // namespace
}  // namespace ricochet
