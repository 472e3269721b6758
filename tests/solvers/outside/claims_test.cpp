#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "solvers/outside/plugin.h"
#include "tests/support/problems.h"

namespace ricochet::outside {
namespace {

TEST(Claims, AreWhatASolverIsShown) {
  const auto accepts = [](int constraints, bool derivatives, const Problem& problem) {
    return solver_as_claimed({"mine", "1", constraints, derivatives}, "here").accepts(problem);
  };
  const Problem free = sphere(2, 3), limits = disc(), equation = arc(), opaque = limited(7);
  EXPECT_TRUE(accepts(0, true, free));
  EXPECT_FALSE(accepts(0, false, limits));
  EXPECT_FALSE(accepts(0, false, equation));
  EXPECT_TRUE(accepts(1, false, free));
  EXPECT_TRUE(accepts(1, true, limits));
  EXPECT_FALSE(accepts(1, false, equation));
  EXPECT_TRUE(accepts(2, true, equation));
  EXPECT_TRUE(accepts(2, false, opaque));
  EXPECT_FALSE(accepts(2, true, opaque)) << "it has no derivatives";
}

TEST(Claims, AreItsCapabilities) {
  const auto capabilities = [](const Claims& claims) {
    return solver_as_claimed(claims, "here").capabilities;
  };
  EXPECT_EQ(capabilities({"mine", "1"}), Capabilities{});
  EXPECT_EQ(capabilities({"mine", "1", 2, true, true}),
            (Capabilities{.constraints = Capabilities::Constraints::all,
                          .derivatives = Capabilities::Order::gradient,
                          .needs_residuals = true}));
}

TEST(Claims, HoldANameThatCanStandInAList) {
  const auto refused = [](const Claims& claims, const char* reason) {
    try {
      solver_as_claimed(claims, "here");
      ADD_FAILURE() << claims.name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(reason));
    }
  };
  EXPECT_EQ(solver_as_claimed({"Mine_2.0+x-y", "1"}, "here").name, "Mine_2.0+x-y");
  EXPECT_EQ(solver_as_claimed({"mine", "1\x1b[31m\n"}, "here").version, "1\\x1b[31m\\x0a");
  refused({"", "1"}, "here: name \"\"; allowed");
  refused({"a,b", "1"}, "here: name \"a,b\"");
  refused({"a b", "1"}, "here: name");
  refused({"*", "1"}, "here: name");
  refused({std::string(61, 'a'), "1"}, "here: name");
  refused({"mine", "1", 3}, "here: takes_constraints 3; allowed are 0, 1 and 2");
}

}  // namespace
}  // namespace ricochet::outside
