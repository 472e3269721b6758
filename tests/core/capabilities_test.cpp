#include <gtest/gtest.h>

#include "ricochet/solver.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

using Constraints = Capabilities::Constraints;
using Order = Capabilities::Order;

Problem constrained(Eigen::Index inequalities, Eigen::Index equalities) {
  Problem problem = parabola(2);
  problem.equalities = equalities;
  problem.constraints = equalities + inequalities;
  return problem;
}

/// Whether these are accepted: no constraints, an inequality, an equality, both.
std::vector<bool> accepted(const Capabilities& capabilities) {
  std::vector<bool> accepted;
  for (const auto& [inequalities, equalities] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    accepted.push_back(capabilities.accept(constrained(inequalities, equalities)));
  }
  return accepted;
}

TEST(Capabilities, AcceptTheConstraintsThatTheyName) {
  EXPECT_EQ(accepted({}), (std::vector{true, false, false, false}));
  EXPECT_EQ(accepted({.constraints = Constraints::inequalities}),
            (std::vector{true, true, false, false}));
  EXPECT_EQ(accepted({.constraints = Constraints::all}), (std::vector{true, true, true, true}));
  EXPECT_EQ(accepted({.constraints = Constraints::inequalities, .needs_constraints = true}),
            (std::vector{false, true, false, false}));
  EXPECT_EQ(accepted({.constraints = Constraints::all, .needs_constraints = true}),
            (std::vector{false, true, true, true}));
}

TEST(Capabilities, AcceptTheirNumbersOfVariables) {
  const Capabilities two_to_four = {.least_variables = 2, .most_variables = 4};
  for (const Eigen::Index n : {1, 2, 3, 4, 5}) {
    EXPECT_EQ(two_to_four.accept(parabola(n)), n >= 2 && n <= 4) << n;
    EXPECT_TRUE(Capabilities().accept(parabola(n))) << n;
  }
}

TEST(Capabilities, AcceptOnlyWhatHasAllThatTheyNeed) {
  Problem full = parabola(2);
  full.lagrangian_hessian = [](const Vector&, double, const Vector&) { return Matrix(); };
  full.smoothed = [](double) { return parabola(2); };
  Problem bare = parabola(2);
  bare.differentiate = nullptr;
  bare.residuals = nullptr;
  Problem without_gradient = full;
  without_gradient.differentiate = nullptr;
  for (const Capabilities& each :
       {Capabilities{.derivatives = Order::gradient}, Capabilities{.derivatives = Order::hessian},
        Capabilities{.needs_residuals = true}, Capabilities{.needs_smoothing = true}}) {
    EXPECT_TRUE(each.accept(full)) << each.needs_in_words();
    EXPECT_FALSE(each.accept(bare)) << each.needs_in_words();
  }
  EXPECT_FALSE(Capabilities{.derivatives = Order::hessian}.accept(parabola(2)));
  EXPECT_FALSE(Capabilities{.derivatives = Order::hessian}.accept(without_gradient));
  EXPECT_TRUE(Capabilities().accept(bare));
}

TEST(Capabilities, AcceptNoBoxOfASinglePoint) {
  Problem problem = parabola(2);
  problem.lower[0] = problem.upper[0];
  EXPECT_TRUE(Capabilities().accept(problem));
  problem.lower = problem.upper;
  EXPECT_FALSE(Capabilities().accept(problem));
}

TEST(Capabilities, AreSaidInWords) {
  const auto variables = [](Eigen::Index least, Eigen::Index most) {
    return Capabilities{.least_variables = least, .most_variables = most}.variables_in_words();
  };
  EXPECT_EQ(variables(1, Capabilities::any_number), "any number");
  EXPECT_EQ(variables(2, Capabilities::any_number), "2 or more");
  EXPECT_EQ(variables(1, 8), "up to 8");
  EXPECT_EQ(variables(2, 8), "2 to 8");
  EXPECT_EQ(variables(1, 1), "1");
  const auto constraints = [](Constraints kind, bool needed) {
    return Capabilities{.constraints = kind, .needs_constraints = needed}.constraints_in_words();
  };
  EXPECT_EQ(constraints(Constraints::none, false), "none");
  EXPECT_EQ(constraints(Constraints::inequalities, false), "inequalities");
  EXPECT_EQ(constraints(Constraints::inequalities, true), "needs inequalities");
  EXPECT_EQ(constraints(Constraints::all, false), "all");
  EXPECT_EQ(constraints(Constraints::all, true), "needs some");
  EXPECT_EQ(Capabilities().needs_in_words(), "nothing");
  EXPECT_EQ((Capabilities{.derivatives = Order::hessian}).needs_in_words(), "Hessians");
  EXPECT_EQ((Capabilities{.needs_residuals = true}).needs_in_words(), "residuals");
  EXPECT_EQ(
      (Capabilities{.derivatives = Order::gradient, .needs_smoothing = true}).needs_in_words(),
      "gradients, smoothing");
}

}  // namespace
}  // namespace ricochet
