#include "src/analysis/comparison/solver_pages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

/// A run of 100 evaluations that returned a solving point, first evaluated after so many, or none.
Outcome ending_run(std::optional<std::int64_t> solved, const std::string& reason) {
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
report::Results pages() {
  const Campaign campaign(plan_from("[[part]]\nproblems = \"bowl-[128]\"\nsolvers = \"*\"\nbudgets "
                                    "= [5, 100]\ninstances = 2\n",
                                    "test"),
                          made_up_catalogue());
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const auto both = [](std::optional<std::int64_t> first, std::optional<std::int64_t> second) {
      return std::vector{ending_run(first, "short"), ending_run(second, first ? "short" : "spent")};
    };
    if (cell.cell.budget == 5) return both({}, {});
    const std::string& problem = cell.cell.problem;
    if (cell.cell.solver == "chance-a" && problem == "bowl-1") return both(10, {});
    if (cell.cell.solver == "chance-a" && problem == "bowl-2") return both(40, 40);
    if (cell.cell.solver == "chance-b" && problem == "bowl-1") return both(50, 50);
    return both({}, {});
  });
  const std::vector<ReportedPart> reported = reported_parts(campaign);
  const auto sets = entry_sets_of(campaign, results, reported);
  return solvers_page(campaign, results, sets, speed_accuracy_table(campaign, sets),
                      leader_table(rated_parts(campaign, results, reported)));
}

report::Results part_of(const report::Results& all, const std::string& solver) {
  for (const report::Part& part : all.parts.at("solvers")) {
    if (part.id == solver) return part.results;
  }
  throw std::out_of_range(solver);
}

TEST(SolverPages, CountProblemsSolvedByTheReturnedPointWithTheLargestBudget) {
  const report::Results all = pages();
  const Table& solvers = *all.table("solvers");
  ASSERT_EQ(solvers.rows.size(), 3U);
  EXPECT_EQ(solvers[0].text("solver"), "chance-a");
  EXPECT_EQ(solvers[0].number("solved"), 2);
  EXPECT_EQ(solvers[0].number("problems"), 3);
  EXPECT_EQ(solvers[0].number("families"), 1);
  EXPECT_EQ(solvers[0].text("fronts"), "bowl");
  EXPECT_EQ(solvers[2].number("solved"), 0);
  EXPECT_EQ(solvers[2].text("fronts"), "");
  EXPECT_EQ(*part_of(all, "luck").value("summary"),
            Value("It solved 0 of the 3 problems that it takes. It is furthest behind on bowl-1 (0 "
                  "%; chance-b 100 %)."));
  EXPECT_EQ(solvers[0].text("first"), "bowl");
  EXPECT_EQ(*part_of(all, "chance-a").value("summary"),
            Value("It solved 2 of the 3 problems that it takes. It is first by mean rank on bowl. "
                  "It is furthest behind on bowl-1 (50 %; chance-b 100 %)."));
}

TEST(SolverPages, HaveSuccessRateAndRunningTimeOfEachFamily) {
  const report::Results part = part_of(pages(), "chance-a");
  const Row row = (*part.table("families"))[0];
  EXPECT_EQ(row.text("family"), "bowl");
  EXPECT_DOUBLE_EQ(row.number("share"), 0.5);
  // (10 + 100) / 1 of one variable, as a run in two solved; 40 / 2 of two: the mean is geometric.
  EXPECT_NEAR(row.number("running_time"), std::sqrt(110.0 * 20.0), 1e-9);
  EXPECT_EQ(row.number("solved"), 2);
  EXPECT_EQ(row.text("front"), "on the front");
  const report::Results luck = part_of(pages(), "luck");
  EXPECT_TRUE(is_missing((*luck.table("families"))[0]["running_time"]));
  EXPECT_EQ((*luck.table("families"))[0].text("front"), "chance-a 50 %");
}

TEST(SolverPages, CountTerminationReasonsOfAllRuns) {
  const report::Results all = pages();
  const Table reasons = where(*all.table("terminations"), "solver", std::string("luck"));
  ASSERT_EQ(reasons.rows.size(), 2U);
  EXPECT_EQ(reasons[0].number("times"), 6);
  EXPECT_EQ(reasons[1].number("times"), 6);
  EXPECT_EQ(reasons[0].number("share"), 0.5);
  const Row first = (*all.table("terminations"))[0];
  EXPECT_EQ(first.text("solver"), "chance-a");
  EXPECT_EQ(first.text("reason"), "short");
  EXPECT_EQ(first.number("times"), 8);
  EXPECT_EQ(*part_of(all, "luck").value("ends"), Value("short 50 %; spent 50 %"));
}

TEST(SolverPages, HaveTheFamiliesOnWhoseFrontTheSolverIsFirstThenThoseFurthestBehind) {
  const Campaign campaign(
      plan_from("[[part]]\nproblems = [\"bowl-1\", \"bowl-2\", \"cup-s\"]\nsolvers = "
                "\"chance-*\"\nbudgets = 100\ninstances = 2\n",
                "test"),
      made_up_catalogue());
  // chance-a is far behind on bowls, and alone on cups.
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const bool solves = (cell.cell.problem == "cup-s") == (cell.cell.solver == "chance-a");
    const auto run = ending_run(solves ? std::optional<std::int64_t>(9) : std::nullopt, "spent");
    return std::vector{run, run};
  });
  const std::vector<ReportedPart> reported = reported_parts(campaign);
  const auto sets = entry_sets_of(campaign, results, reported);
  const report::Results page =
      solvers_page(campaign, results, sets, speed_accuracy_table(campaign, sets),
                   leader_table(rated_parts(campaign, results, reported)));
  const report::Results own = part_of(page, "chance-a");
  const Table& families = *own.table("families");
  ASSERT_EQ(families.rows.size(), 2U);
  EXPECT_EQ(families[0].text("family"), "cup");
  EXPECT_TRUE(families[0].is("on_front"));
  EXPECT_EQ(families[1].text("family"), "bowl");
  EXPECT_EQ(families[1].number("behind"), 1);
}

TEST(SolverPages, NameTheSolversOfALibraryThatIsOld) {
  std::vector<Solver> solvers = {chance("mads"), chance("ipopt"), chance("ipopt-tuned")};
  EXPECT_TRUE(library_notes(solvers).rows.empty());
  solvers[1].version = solvers[2].version = "Ipopt 3.11.9";
  const Table notes = library_notes(solvers);
  ASSERT_EQ(notes.rows.size(), 1U);
  EXPECT_EQ(notes[0].text("version"), "Ipopt 3.11.9");
  EXPECT_EQ(notes[0].text("solvers"), "ipopt, ipopt-tuned");
}

TEST(SolverPages, HaveNoSettingsOfSolversThatTheSuiteDoesNotKnow) {
  EXPECT_TRUE(is_missing(*part_of(pages(), "luck").value("settings")));
}

}  // namespace
}  // namespace ricochet::studies::comparison
