#include "src/analysis/comparison/solver_pages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A run of 100 evaluations that returned a solving point, first evaluated after so many, or none.
Outcome run_of(std::optional<std::int64_t> solved, const std::string& reason) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.seconds = 1;
  outcome.verdict.solved = outcome.verdict.returned_solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  if (solved) outcome.verdict.seconds_to_solve = 0.01 * static_cast<double>(*solved);
  outcome.verdict.optimality_gap = outcome.verdict.returned_optimality_gap = solved ? 0.0 : 1.0;
  outcome.steps = {{solved.value_or(50), 0.1, *outcome.verdict.optimality_gap}};
  outcome.terminations = {reason};
  return outcome;
}

/// On bowls of 1, 2 and 8 variables: chance-a solves one of two runs of the first, after 10, and
/// both of the second, after 40; chance-b both of the first, after 50; luck and all others nothing.
Json pages() {
  const Campaign campaign(plan_from("[[part]]\nproblems = \"bowl-[128]\"\nsolvers = \"*\"\nbudgets "
                                    "= [5, 100]\ninstances = 2\n",
                                    "test"),
                          made_up_catalogue());
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const auto both = [](std::optional<std::int64_t> first, std::optional<std::int64_t> second) {
      return std::vector{run_of(first, "short"), run_of(second, first ? "short" : "spent")};
    };
    if (cell.cell.budget == 5) return both({}, {});
    const std::string& problem = cell.cell.problem;
    if (cell.cell.solver == "chance-a" && problem == "bowl-1") return both(10, {});
    if (cell.cell.solver == "chance-a" && problem == "bowl-2") return both(40, 40);
    if (cell.cell.solver == "chance-b" && problem == "bowl-1") return both(50, 50);
    return both({}, {});
  });
  const auto sets = entry_sets_of(campaign, results, reported_parts(campaign));
  return solvers_page(campaign, results, sets,
                      speed_accuracy_data(campaign, sets)["speed_accuracy"]);
}

Json page_of(const Json& all, const std::string& solver) {
  for (const Json& page : all["pages"]) {
    if (page["folder"] == solver) return page["data"];
  }
  throw std::out_of_range(solver);
}

TEST(SolverPages, CountProblemsSolvedByTheReturnedPointWithTheLargestBudget) {
  const Json all = pages();
  ASSERT_EQ(all["solvers"].size(), 3U);
  EXPECT_EQ(all["solvers"][0]["solver"], "chance-a");
  EXPECT_EQ(all["solvers"][0]["solved"], 2);
  EXPECT_EQ(all["solvers"][0]["problems"], 3);
  EXPECT_EQ(all["solvers"][0]["families"], 1);
  EXPECT_EQ(all["solvers"][2]["solved"], 0);
  EXPECT_EQ(page_of(all, "luck")["unsolved_by_all"], 1);
}

TEST(SolverPages, HaveSuccessRateAndRunningTimeOfEachFamily) {
  const Json row = page_of(pages(), "chance-a")["families"].at(0);
  EXPECT_EQ(row["family"], "bowl");
  EXPECT_DOUBLE_EQ(row["share"].get<double>(), 0.5);
  // (10 + 100) / 1 of one variable, as a run in two solved; 40 / 2 of two: the mean is geometric.
  EXPECT_NEAR(row["running_time"].get<double>(), std::sqrt(110.0 * 20.0), 1e-9);
  EXPECT_EQ(row["solved"], 2);
  EXPECT_TRUE(page_of(pages(), "luck")["families"][0]["running_time"].is_null());
}

TEST(SolverPages, SayWhoIsAheadWhereTheSolverIsNotOnTheFront) {
  const Json all = pages();
  EXPECT_EQ(page_of(all, "chance-a")["fronts"], Json{"bowl"});
  EXPECT_TRUE(page_of(all, "chance-a")["families"][0]["ahead"].is_null());
  EXPECT_EQ(page_of(all, "luck")["fronts"], Json::array());
  EXPECT_EQ(page_of(all, "luck")["families"][0]["ahead"], "chance-a");
}

TEST(SolverPages, NameTheProblemOfAFamilyOnWhichAnotherSolvedMostMore) {
  const Json all = pages();
  const Json b = page_of(all, "chance-b")["failed"];
  ASSERT_EQ(b.size(), 1U);
  EXPECT_EQ(b[0]["problem"], "bowl-2");
  EXPECT_EQ(b[0]["share"], 0);
  EXPECT_EQ(b[0]["behind"], 1);
  EXPECT_EQ(b[0]["of"], 3);
  EXPECT_EQ(b[0]["best"], "chance-a");
  EXPECT_EQ(b[0]["best_share"], 1);
  const Json a = page_of(all, "chance-a")["failed"];
  ASSERT_EQ(a.size(), 1U);
  EXPECT_EQ(a[0]["problem"], "bowl-1");
  EXPECT_EQ(a[0]["share"], 0.5);
}

TEST(SolverPages, CountTerminationReasonsOfAllRuns) {
  const Json reasons = page_of(pages(), "luck")["terminations"];
  ASSERT_EQ(reasons.size(), 2U);
  EXPECT_EQ(reasons[0]["times"].get<int>() + reasons[1]["times"].get<int>(), 12);
  EXPECT_EQ(reasons[0]["times"], 6);
  EXPECT_EQ(reasons[0]["share"], 0.5);
  const Json of_a = page_of(pages(), "chance-a")["terminations"];
  EXPECT_EQ(of_a[0], (Json{{"reason", "short"}, {"times", 8}, {"share", 8 / 12.0}}));
}

TEST(SolverPages, NameTheSolversOfALibraryThatIsOld) {
  std::vector<Solver> solvers = {chance("mads"), chance("ipopt"), chance("ipopt-tuned")};
  EXPECT_EQ(library_notes(solvers), Json::array());
  solvers[1].version = solvers[2].version = "Ipopt 3.11.9";
  const Json notes = library_notes(solvers);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0]["version"], "Ipopt 3.11.9");
  EXPECT_EQ(notes[0]["solvers"], (Json{"ipopt", "ipopt-tuned"}));
}

TEST(SolverPages, HaveNoSettingsOfSolversThatTheSuiteDoesNotKnow) {
  EXPECT_TRUE(page_of(pages(), "luck")["settings"].is_null());
}

}  // namespace
}  // namespace ricochet::studies::comparison
