#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
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
  // A gradient of one variable costs one evaluation at both prices.
  EXPECT_EQ(measured,
            (std::map<std::string, std::int64_t>{{"profile-wear-16-C4", 2}, {"hs-71", 1}}));
}

/// The number of problems and families that README and docs/benchmark-method.md name; pathological
/// problems are counted apart.
TEST(Catalogue, HasAsManyProblemsAsTheDocumentsSay) {
  std::size_t problems = 0, families = 0, small = 0;
  for (const Family& family : suite_families()) {
    if (family.problems.front().hazardous) continue;
    ++families;
    problems += family.problems.size();
    small += static_cast<std::size_t>(std::ranges::count_if(
        family.problems, [](const Problem& problem) { return problem.dimension() <= 100; }));
  }
  const auto says = [](const char* file, const std::string& sentence) {
    std::ifstream stream(std::string(RICOCHET_SOURCE "/") + file);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::ranges::replace(text, '\n', ' ');
    EXPECT_THAT(text, testing::HasSubstr(sentence)) << file;
  };
  says("README.md", fmt::format("with problems of the literature, {} in all,", problems));
  says("docs/benchmark-method.md",
       fmt::format("ricochet has {} problems in {} families", problems, families));
  says("docs/benchmark-method.md", fmt::format("`list problems` has all {}.", problems));
  says("docs/benchmark-method.md", fmt::format("They are not among the {}:", problems));
  says("docs/benchmark-method.md", fmt::format("takes the {} of up to 100 variables", small));
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
