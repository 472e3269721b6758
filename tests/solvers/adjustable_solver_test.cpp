#include "solvers/adjustable_solver.h"

#include <gtest/gtest.h>

#include <string>

namespace ricochet {
namespace {

TEST(SolverOption, AllowsWhatItsRangeSays) {
  const SolverOption whole = whole_option("points", 5, 20);
  EXPECT_EQ(whole.range(), "a whole number from 5 to 1000000");
  EXPECT_EQ(whole.usual, "20");
  for (const double value : {5.0, 6.0, 1e6}) EXPECT_TRUE(whole.allows(value)) << value;
  for (const double value : {4.0, 5.5, 1e6 + 1}) EXPECT_FALSE(whole.allows(value)) << value;
  EXPECT_FALSE(whole.allows(std::string("6")));

  SolverOption share = real_option("share", 0, 0.5, 0.1);
  EXPECT_TRUE(share.allows(0.0) && share.allows(0.5) && share.allows(0.3));
  share.without_least = share.without_most = true;
  EXPECT_EQ(share.range(), "a number from 0 to 0.5, but not 0, but not 0.5");
  EXPECT_TRUE(!share.allows(0.0) && !share.allows(0.5) && share.allows(0.3));
}

TEST(SolverOption, IsAWordWhereThereAreSome) {
  SolverOption option{.name = "strategy", .usual = "mild", .words = {"mild", "bold"}};
  EXPECT_EQ(option.range(), "\"mild\", \"bold\"");
  EXPECT_TRUE(option.allows(std::string("bold")));
  EXPECT_FALSE(option.allows(std::string("rash")));
  EXPECT_FALSE(option.allows(0.0));
  option.words = {"*"};
  EXPECT_EQ(option.range(), "a text");
  EXPECT_TRUE(option.allows(std::string("rash")));
}

TEST(SolverOption, IsTheUsualWhereItIsNotGiven) {
  const GivenOptions given = {{"points", 7.0}};
  EXPECT_EQ(whole_of(given, "points", 20), 7);
  EXPECT_EQ(whole_of(given, "others", 20), 20);
  EXPECT_EQ(number_of(given, "share", 0.25), 0.25);
}

}  // namespace
}  // namespace ricochet
