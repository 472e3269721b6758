#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "src/analysis/comparison/pairs.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr int twelve = 12;

/// Twelve solvers, of which every second is stochastic and every third needs gradients; which solve
/// one bowl as `solved` says.
Json data_of(const std::function<bool(int)>& solved) {
  Catalogue catalogue = made_up_catalogue();
  Problem smooth = bowl("bowl-1", 1);
  smooth.differentiate = [](const Vector&) { return Derivatives(); };  // no solver here asks
  catalogue.families = {{"bowl", {smooth}}};
  catalogue.solvers.clear();
  for (int s = 0; s < twelve; ++s) {
    Solver solver = chance("s" + std::to_string(s));
    solver.stochastic = s % 2 == 0;
    if (s % 3 == 0) solver.capabilities.derivatives = Capabilities::Order::gradient;
    catalogue.solvers.push_back(solver);
  }
  const Campaign campaign(
      plan_from(
          "[[part]]\nproblems = \"bowl-1\"\nsolvers = \"*\"\nbudgets = [10, 100]\ninstances = 2\n",
          "test"),
      catalogue);
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    Outcome outcome;
    outcome.verdict.returned_solved =
        cell.cell.budget == 100 && solved(std::stoi(cell.cell.solver.substr(1)));
    return std::vector{outcome, outcome};
  });
  return separation_data(comparison_of(campaign, results, {}), 0);
}

TEST(Separation, NamesThePropertyThatTellsWhoSolves) {
  const Json data = data_of([](int s) { return s % 2 == 0; });
  EXPECT_EQ(data["entries"], twelve);
  EXPECT_EQ(data["solving"], twelve / 2);
  EXPECT_EQ(data["separates"], "stochastic");
  EXPECT_EQ(data["those"], 1);
  EXPECT_EQ(data["others"], 0);
  EXPECT_EQ(data_of([](int s) { return s % 3 != 0; })["separates"], "gradients");
}

TEST(Separation, NamesNoneWhereChanceMayHaveMadeIt) {
  const Json data = data_of([](int s) { return s < 5; });
  EXPECT_EQ(data["solving"], 5);
  EXPECT_TRUE(data["separates"].is_null());
  EXPECT_TRUE(data_of([](int) { return true; })["separates"].is_null());
}

}  // namespace
}  // namespace ricochet::studies::comparison
