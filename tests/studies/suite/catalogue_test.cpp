#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "src/studies/suite/suite.h"

namespace ricochet::studies {
namespace {

/// Evaluations charged for one value with its gradient, beside the value.
std::int64_t charged_for_a_gradient(const Campaign& campaign, const PlannedCell& cell) {
  const Problem problem = campaign.problems()[cell.problem].formulated(cell.formulation);
  Evaluator evaluator(problem, cell.budget);
  EXPECT_TRUE(evaluator.derivatives(problem.start));
  return evaluator.ledger().charged - 1;
}

TEST(Catalogue, ChargesAGradientWhatItWasMeasuredToTakeWhereAPlanSaysSo) {
  const Campaign campaign(
      plan_from("[[part]]\nproblems = [\"profile-wear-16-C4\", \"top-speed-C1\", \"hs-71\"]\n"
                "solvers = \"nlopt-slsqp\"\nformulations = [\"original\", \"surrogate\"]\n"
                "gradient_prices = [\"measured\", \"n\"]\nbudgets = 100",
                "test"),
      whole_catalogue());
  std::map<std::string, std::int64_t> measured;
  for (const PlannedCell& cell : campaign.cells()) {
    const std::int64_t charged = charged_for_a_gradient(campaign, cell);
    if (cell.cell.gradient_price == "measured") {
      measured[cell.cell.problem] = charged;
    } else {
      EXPECT_EQ(charged, campaign.problems()[cell.problem].dimension());
    }
  }
  EXPECT_EQ(measured, (std::map<std::string, std::int64_t>{
                          {"profile-wear-16-C4", 2}, {"top-speed-C1", 1}, {"hs-71", 1}}));
}

/// An ordinary plan must not hang, and an archive's plan of all problems keeps its meaning.
TEST(Catalogue, LeavesPathologicalProblemsToPlansThatNameThem) {
  const auto chosen = [](const std::string& problems) {
    const Campaign campaign(plan_from("[[part]]\nproblems = " + problems +
                                          "\nsolvers = [\"random-search\", \"nlopt-cobyla\"]\n"
                                          "budgets = 1\ninstances = 1",
                                      "test"),
                            whole_catalogue());
    int pathological = 0;
    for (const Problem& problem : campaign.problems()) pathological += problem.hazardous ? 1 : 0;
    return std::pair(pathological, std::ssize(campaign.problems()) - pathological);
  };
  EXPECT_EQ(chosen("\"pathological-*\""), std::pair(9, std::ptrdiff_t{0}));
  EXPECT_EQ(chosen("[\"*-throws\", \"classic-b*\"]"), std::pair(0, std::ptrdiff_t{3}));
}

TEST(Catalogue, NamesThePlaceOfAMachineThatItDoesNotKnow) {
  const auto said = [](const std::string& machines) -> std::string {
    try {
      const Campaign campaign(
          plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"scan\"\nbudgets = 9\n"
                    "machines = {around = " +
                        machines + "}",
                    "test"),
          whole_catalogue());
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  using testing::StartsWith;
  EXPECT_EQ(said("\"C1\", frictoin = 0.5"),
            "part 1, machines: there is no key frictoin; did you mean friction?");
  EXPECT_THAT(said("\"C1\", friction = -1"),
              StartsWith("part 1, machines: friction = -1: must be"));
  EXPECT_THAT(said("\"C1\", fidelity = \"auto\""), StartsWith("part 1, machines: fidelity = auto"));
  EXPECT_THAT(said("\"C1\", restitution = 1.5"), StartsWith("part 1, machines: C1-r1.5"));
  EXPECT_THAT(said("\"C99\""), StartsWith("part 1, machines: C99"));
}

}  // namespace
}  // namespace ricochet::studies
