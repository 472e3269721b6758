#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A run that solved its problem with the last of what it asked for, or not at all.
Outcome run_of(std::int64_t values, std::int64_t derivatives, double seconds, bool solved = true) {
  Outcome outcome;
  outcome.evaluations = values + derivatives;
  outcome.values = values;
  outcome.derivatives = derivatives;
  outcome.seconds = seconds;
  outcome.verdict.solved = outcome.verdict.returned_solved = solved;
  if (solved) {
    outcome.verdict.evaluations_to_solve = outcome.evaluations;
    outcome.verdict.seconds_to_solve = seconds;
  }
  return outcome;
}

/// On problems of one and of two variables chance-a has `a` as its only run, chance-b `b`; luck
/// never solves anything.
Json rows_of(const Outcome& a, const Outcome& b) {
  const Campaign campaign(
      plan_from("name = \"t\"\n[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"*\"]\n"
                "budgets = [100]\ninstances = 1\n",
                "test"),
      made_up_catalogue());
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    const std::string& solver = cell.cell.solver;
    return std::vector{solver == "luck" ? run_of(100, 0, 0.1, false)
                                        : (solver == "chance-a" ? a : b)};
  });
  const Json data =
      break_even_data(campaign, entry_sets_of(campaign, results, reported_parts(campaign)));
  EXPECT_EQ(data.size(), 1);
  // A millisecond an evaluation; one of the second problem takes two simulations.
  EXPECT_NEAR(data[0]["here"][0]["simulation"].get<double>(), 1e-3 / std::sqrt(2.0), 1e-12);
  return data[0]["rows"];
}

std::vector<Json> at_price(const Json& rows, const std::string& price) {
  std::vector<Json> some;
  for (const Json& row : rows) {
    if (row["price"] == price) some.push_back(row);
  }
  return some;
}

// A asks for 100 values, a millisecond each; B for 10, and computes for the rest of a second. For
// each variable, mean over both problems: 100 against 10 simulations, 0.7425 s of computing.
TEST(BreakEven, IsWhereComputingLessAndAskingLessTakeAsLong) {
  const Json rows = rows_of(run_of(100, 0, 0.1), run_of(10, 0, 1));
  for (const std::string price : {"0", "measured", "n"}) {
    const auto some = at_price(rows, price);
    ASSERT_EQ(some.size(), 2) << price;
    EXPECT_EQ(some[0]["solver"], "chance-a");
    EXPECT_TRUE(some[0]["from"].is_null());
    EXPECT_NEAR(some[0]["until"].get<double>(), 0.7425 / 90, 1e-8);
    EXPECT_EQ(some[1]["solver"], "chance-b");
    EXPECT_EQ(some[1]["from"], some[0]["until"]);
    EXPECT_TRUE(some[1]["until"].is_null());
    EXPECT_EQ(some[1]["sure"], 1) << "on both problems the same is ahead";
  }
}

// 100 values against 60 with a gradient each: at n 60 + 60 simulations for one variable, 60 + 120
// for each of two.
TEST(BreakEven, DependsOnThePriceOfAGradient) {
  const Json rows = rows_of(run_of(100, 0, 0.1), run_of(60, 60, 1));
  const auto free = at_price(rows, "0");
  ASSERT_EQ(free.size(), 2);
  EXPECT_EQ(free[1]["solver"], "chance-b");
  const auto dear = at_price(rows, "n");
  ASSERT_EQ(dear.size(), 1);
  EXPECT_EQ(dear[0]["solver"], "chance-a");
  EXPECT_TRUE(dear[0]["until"].is_null());
}

// It solves half way: what it asks for later is not its cost.
TEST(BreakEven, CountsARunUntilItSolves) {
  Outcome half = run_of(100, 0, 0.1);
  half.verdict.evaluations_to_solve = 5;
  half.verdict.seconds_to_solve = 0.005;
  const Json rows = rows_of(half, run_of(10, 0, 1));
  ASSERT_EQ(at_price(rows, "n").size(), 1);
  EXPECT_EQ(at_price(rows, "n")[0]["solver"], "chance-a");
}

}  // namespace
}  // namespace ricochet::studies::comparison
