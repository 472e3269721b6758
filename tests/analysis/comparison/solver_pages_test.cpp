#include "src/analysis/comparison/solver_pages.h"

#include "ricochet/solver.h"
#include "src/analysis/comparison/leaders.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/test.h"

namespace ricochet::studies::comparison {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SolverFacts, HaveTheSettingsAndTheKindOfEverySolverOfTheSuite) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_TRUE(settings_of(solver.name).has_value()) << solver.name;
    EXPECT_NE(kind_of(solver.name), "other") << solver.name;
  }
  for (const MissingSolver& missing : missing_solvers()) {
    EXPECT_TRUE(settings_of(missing.solver).has_value()) << missing.solver;
  }
  EXPECT_EQ(settings_of("ipopt-tuned")->from, "tuned to this suite");
  EXPECT_EQ(settings_of("ipopt")->from, "Ipopt");
  EXPECT_EQ(kind_of("fireworks-authors"), "fireworks");
  EXPECT_EQ(kind_of("nlopt-auglag-bobyqa"), "models");
  EXPECT_EQ(kind_of("nlopt-auglag-lbfgs"), "derivatives");
  EXPECT_FALSE(settings_of("hill-climber").has_value()) << "a user's";
  EXPECT_EQ(kind_of("hill-climber"), "other");
}

// Whoever reads a name must know that the solver was tuned on what it is compared on.
TEST(SolverFacts, SayOfEverySolverThatWasTunedToTheSuite) {
  for (const Solver& solver : all_solvers()) {
    const SolverSettings settings = settings_of(solver.name).value();
    const bool named_so = solver.name.ends_with("-tuned");
    const bool says = settings.from.find("tuned to this suite") != std::string::npos ||
                      settings.from.find("did best here") != std::string::npos || named_so;
    EXPECT_TRUE(settings.tuned || !says) << solver.name;
    EXPECT_EQ(tuned_mark(solver.name).empty(), !settings.tuned || named_so) << solver.name;
  }
  EXPECT_EQ(tuned_mark("continuation-nlopt-slsqp"), " (tuned to this suite)");
  EXPECT_EQ(tuned_mark("mads"), "");
  EXPECT_EQ(tuned_mark("ipopt"), "");
}

TEST(SolverFacts, SayHowOldALibraryIsAndWhichSolversAreOfIt) {
  EXPECT_THAT(library_note("Ipopt 3.11.9"), HasSubstr("2014"));
  EXPECT_EQ(library_note("Ipopt 3.14.0"), "");
  EXPECT_EQ(library_note("NLopt 2.7.1"), "");
  std::vector<Solver> solvers = {chance("mads"), chance("ipopt"), chance("ipopt-tuned")};
  EXPECT_THAT(rows_of(library_notes(solvers), "version"), ElementsAre());
  solvers[1].version = solvers[2].version = "Ipopt 3.11.9";
  EXPECT_THAT(rows_of(library_notes(solvers), "version,solvers"),
              ElementsAre("Ipopt 3.11.9 | ipopt, ipopt-tuned"));
}

Outcome ending(Outcome outcome, const std::string& reason) {
  outcome.terminations = {reason};
  return outcome;
}

report::Results pages_of(const std::string& plan, const RunsOf& runs_of) {
  const MadeUp made(plan, runs_of);
  const auto sets = made.sets();
  return solvers_page(made.campaign, made.results, sets, speed_accuracy_table(made.campaign, sets),
                      leader_table(made.rated()));
}

/// On bowls of 1, 2 and 8 variables: chance-a solves one of two runs of the first, after 10, and
/// both of the second, after 40; chance-b both of the first, after 50; luck and all others nothing.
report::Results pages() {
  return pages_of(part_of("\"bowl-[128]\"", "solvers = \"*\"\nbudgets = [5, 100]\ninstances = 2"),
                  [](const PlannedCell& cell) {
                    const auto both = [](std::optional<std::int64_t> first,
                                         std::optional<std::int64_t> second) {
                      return std::vector{ending(run_of(first), "short"),
                                         ending(run_of(second), first ? "short" : "spent")};
                    };
                    if (cell.cell.budget == 5) return both({}, {});
                    const std::string on = cell.cell.solver + " on " + cell.cell.problem;
                    if (on == "chance-a on bowl-1") return both(10, {});
                    if (on == "chance-a on bowl-2") return both(40, 40);
                    if (on == "chance-b on bowl-1") return both(50, 50);
                    return both({}, {});
                  });
}

report::Results page_of(const report::Results& all, const std::string& solver) {
  for (const report::Part& part : all.parts.at("solvers")) {
    if (part.id == solver) return part.results;
  }
  throw std::out_of_range(solver);
}

TEST(SolverPages, CountProblemsSolvedByTheReturnedPointWithTheLargestBudget) {
  const report::Results all = pages();
  EXPECT_THAT(rows_of(*all.table("solvers"), "solver,solved,problems,families,fronts,first"),
              ElementsAre("chance-a | 2 | 3 | 1 | bowl | bowl",
                          testing::StartsWith("chance-b | 1 | 3 | 1 | "),
                          testing::StartsWith("luck | 0 | 3 | 1 |  | ")));
  EXPECT_EQ(*page_of(all, "luck").value("summary"),
            Value("It solved 0 of the 3 problems that it takes. It is furthest behind on bowl-1 (0 "
                  "%; chance-b 100 %)."));
  EXPECT_EQ(*page_of(all, "chance-a").value("summary"),
            Value("It solved 2 of the 3 problems that it takes. It is first by mean rank on bowl. "
                  "It is furthest behind on bowl-1 (50 %; chance-b 100 %)."));
  EXPECT_TRUE(is_missing(*page_of(all, "luck").value("settings"))) << "none of the suite";
}

TEST(SolverPages, HaveSuccessRateAndRunningTimeOfEachFamily) {
  const report::Results all = pages();
  const report::Results own = page_of(all, "chance-a");
  const Table& families = *own.table("families");
  EXPECT_THAT(rows_of(families, "family,share,solved,front"),
              ElementsAre("bowl | 0.5 | 2 | on the front"));
  // (10 + 100) / 1 of one variable, as a run in two solved; 40 / 2 of two: the mean is geometric.
  EXPECT_NEAR(families[0].number("running_time"), std::sqrt(110.0 * 20.0), 1e-9);
  EXPECT_THAT(rows_of(*page_of(all, "luck").table("families"), "running_time,front"),
              ElementsAre("- | chance-a 50 %"));
}

TEST(SolverPages, CountTerminationReasonsOfAllRuns) {
  const report::Results all = pages();
  const auto reasons = rows_of(*all.table("terminations"), "solver,reason,times,share");
  EXPECT_THAT(reasons.front(), testing::StartsWith("chance-a | short | 8 | "));
  EXPECT_THAT(reasons, testing::IsSupersetOf({"luck | short | 6 | 0.5", "luck | spent | 6 | 0.5"}));
  EXPECT_EQ(*page_of(all, "luck").value("ends"), Value("short 50 %; spent 50 %"));
}

TEST(SolverPages, HaveTheFamiliesOnWhoseFrontTheSolverIsFirstThenThoseFurthestBehind) {
  // chance-a is far behind on bowls, and alone on cups.
  const report::Results page =
      page_of(pages_of(part_of(R"(["bowl-1", "bowl-2", "cup-s"])",
                               "solvers = \"chance-*\"\nbudgets = 100\ninstances = 2"),
                       [](const PlannedCell& cell) {
                         const bool solves =
                             (cell.cell.problem == "cup-s") == (cell.cell.solver == "chance-a");
                         return twice(ending(solves ? run_of(9) : run_of({}), "spent"));
                       }),
              "chance-a");
  EXPECT_THAT(rows_of(*page.table("families"), "family,on_front,behind"),
              ElementsAre(testing::StartsWith("cup | yes | "), "bowl | no | 1"));
}

}  // namespace
}  // namespace ricochet::studies::comparison
