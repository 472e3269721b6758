#include <gtest/gtest.h>

#include <map>
#include <string>

#include "problems/classic/formula.h"
#include "problems/classic/hock_schittkowski.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

// The conditions of Karush, Kuhn and Tucker themselves, coordinate by coordinate.
TEST(Multipliers, BalanceTheGradientButForActiveBounds) {
  int looked = 0;
  for (const Problem& problem : hock_schittkowski_problems()) {
    if (problem.name == "hs-13") continue;  // see below
    if (problem.name == "hs-87") continue;  // its best point lies at a jump
    SCOPED_TRACE(problem.name);
    const std::optional<Vector> multipliers = multipliers_at_best(problem);
    ASSERT_TRUE(multipliers);
    ASSERT_EQ(multipliers->size(), problem.constraints);
    const Vector& best = *problem.best_point;
    const Derivatives d = problem.differentiate(best);
    const double small = 1e-9 * (1 + d.gradient.norm());
    for (Eigen::Index i = problem.equalities; i < problem.constraints; ++i) {
      EXPECT_GE((*multipliers)[i], -small);
      EXPECT_TRUE((*multipliers)[i] == 0 || d.values.constraints[i] > -1e-8);
    }
    const Vector left = d.gradient + d.jacobian.transpose() * *multipliers;
    for (Eigen::Index i = 0; i < best.size(); ++i) {
      const bool at_lower = best[i] - problem.lower[i] <= 1e-8;
      const bool at_upper = problem.upper[i] - best[i] <= 1e-8;
      EXPECT_TRUE(at_lower || left[i] < small) << "coordinate " << i;
      EXPECT_TRUE(at_upper || left[i] > -small) << "coordinate " << i;
    }
    ++looked;
  }
  EXPECT_EQ(looked, 114);
}

TEST(Multipliers, AreNoneAtACusp) {
  EXPECT_FALSE(multipliers_at_best(named(hock_schittkowski_problems(), "hs-13")));
}

// Worked by hand from the first-order conditions.
TEST(Multipliers, AreThoseWorkedByHand) {
  const std::map<std::string, double> sums = {{"hs-32", 2}, {"hs-39", 2}, {"hs-53", 440.0 / 43}};
  for (const auto& [name, sum] : sums) {
    const auto multipliers = multipliers_at_best(named(hock_schittkowski_problems(), name));
    ASSERT_TRUE(multipliers) << name;
    EXPECT_NEAR(multipliers->lpNorm<1>(), sum, 1e-10) << name;
  }
}

}  // namespace
}  // namespace ricochet::classic
