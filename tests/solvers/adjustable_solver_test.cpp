#include "solvers/adjustable_solver.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace ricochet {
namespace {

/// Options of a solver that is not there.
struct SomeOptions {
  int points = 20;
  double share = 0.125;
  std::optional<int> population = {};
};

template <class Visit, IsOf<SomeOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(whole_option("points", 5), o.points...);
  Field share = real_option("share", 0, 0.5);
  share.range.without_least = true;
  visit(share, o.share...);
  visit(whole_option("population", 2, 10, "as many as variables"), o.population...);
}

TEST(SolverOption, AllowsWhatItsRangeSays) {
  const std::vector<SolverOption> options = options_in(SomeOptions());
  ASSERT_EQ(options.size(), 3U);
  const SolverOption& whole = options[0];
  EXPECT_EQ(whole.name, "points");
  EXPECT_EQ(whole.allowed(), "a whole number from 5 to 1000000");
  EXPECT_EQ(whole.usual, "20");
  for (const double value : {5.0, 6.0, 1e6}) EXPECT_TRUE(whole.allows(value)) << value;
  for (const double value : {4.0, 5.5, 1e6 + 1}) EXPECT_FALSE(whole.allows(value)) << value;
  EXPECT_FALSE(whole.allows(std::string("6")));
  const SolverOption& share = options[1];
  EXPECT_EQ(share.usual, "0.125");
  EXPECT_EQ(share.allowed(), "a number from 0 to 0.5, but not 0");
  EXPECT_TRUE(!share.allows(0.0) && share.allows(0.5) && share.allows(0.3));
  EXPECT_EQ(options[2].usual, "as many as variables");
}

TEST(SolverOption, IsAWordWhereThereAreSome) {
  SolverOption option{.name = "strategy", .usual = "mild", .words = {"mild", "bold"}};
  EXPECT_EQ(option.allowed(), "\"mild\", \"bold\"");
  EXPECT_TRUE(option.allows(std::string("bold")));
  EXPECT_FALSE(option.allows(std::string("rash")));
  EXPECT_FALSE(option.allows(0.0));
  option.words = {"*"};
  EXPECT_EQ(option.allowed(), "a text");
  EXPECT_TRUE(option.allows(std::string("rash")));
}

TEST(SolverOption, IsTheUsualWhereItIsNotGiven) {
  const SomeOptions options = with_given(SomeOptions(), {{"points", 7.0}, {"population", 3.0}});
  EXPECT_EQ(options.points, 7);
  EXPECT_EQ(options.share, 0.125);
  EXPECT_EQ(options.population, 3);
  EXPECT_EQ(with_given(options, {}).population, 3);
}

}  // namespace
}  // namespace ricochet
