#include "src/analysis/comparison/family.h"
#include "src/analysis/comparison/profiles.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "tests/analysis/comparison/made_up_results.h"

namespace ricochet::studies::comparison {
namespace {

using testing::_;
using testing::UnorderedElementsAre;

/// Two runs with each solver: chance-a solves one of the first problem after 10 evaluations, and
/// both of others after 40; chance-b all after 50; luck none.
std::vector<Outcome> usual_runs(const PlannedCell& cell) {
  if (cell.cell.solver == "luck") return twice(run_of({}));
  if (cell.cell.solver == "chance-b") return twice(run_of(50));
  return cell.cell.problem == "bowl-1" ? std::vector{run_of(10), run_of({})} : twice(run_of(40));
}

TEST(SpeedAccuracy, IsWhatTheRunsCountUpTo) {
  MadeUp made(two_runs(both_bowls), usual_runs);
  const Table table = sorted(speed_accuracy_table(made.campaign, made.sets()), {"solver"});
  EXPECT_THAT(rows_of(table, "solver,share,runs,part,complete,on_front"),
              ElementsAre("chance-a | 0.75 | 4 | 1 | yes | yes", "chance-b | 1 | 4 | 1 | yes | yes",
                          "luck | 0 | 4 | 1 | yes | no"));
  // 10 and 100 of one variable; 40 and 40 of two.
  EXPECT_NEAR(table[0].number("evaluations"), std::sqrt(55.0 * 20.0), 1e-9);
  EXPECT_NEAR(table[0].number("seconds"), std::sqrt((0.1 + 2) / 2 * 0.4), 1e-9);
  EXPECT_LT(table[0].number("lower"), 0.75);
  EXPECT_GT(table[0].number("upper"), 0.75);
  EXPECT_NEAR(table[1].number("evaluations"), std::sqrt(50.0 * 25.0), 1e-9);
  for (const bool by_time : {false, true}) {
    const report::Chart chart = speed_accuracy_chart(table, by_time);
    ASSERT_EQ(chart.series.size(), 2U) << "the front, and solvers of one kind";
    EXPECT_EQ(chart.series[0].samples.size(), by_time ? 2U : 3U) << "the front, and its end";
    EXPECT_EQ(chart.series[1].samples[0].name, "chance-b");
    EXPECT_EQ(chart.series[1].samples[0].value, 100);
  }
  EXPECT_EQ(front_sentence(table),
            "2 of 3 solvers are on the Pareto front; 0 more are statistically tied with the most "
            "accurate, chance-b.");
  // Who takes some only is not on the front.
  std::erase_if(made.results, [](const CellResult& s) {
    return s.cell->cell.solver == "chance-a" && s.cell->cell.problem == "bowl-1";
  });
  EXPECT_THAT(
      rows_of(speed_accuracy_table(made.campaign, made.sets()), "solver,complete,on_front"),
      UnorderedElementsAre("chance-a | no | no", "chance-b | yes | yes", "luck | yes | no"));
}

TEST(SpeedAccuracy, OfNothingOrOneIsNothingOrOne) {
  const MadeUp made(two_runs("\"bowl-1\"", "luck"), usual_runs);
  EXPECT_TRUE(speed_accuracy_table(made.campaign, {}).rows.empty());
  const auto sets = made.sets();
  EXPECT_THAT(rows_of(speed_accuracy_table(made.campaign, sets), "share"), ElementsAre("0"));
  EXPECT_FALSE(sets[0].compared());
  const MadeUp joined(two_runs(R"(["bowl-1", "cup-s"])"), usual_runs);
  EXPECT_EQ(
      rows_of(speed_accuracy_table(joined.campaign, joined.sets()), "family,budget,solver,share")
          .front(),
      "all | - | chance-a | 0.75")
      << "of two families of which each solver takes all";
}

TEST(Kinds, HaveTheirBestAndThePapersAlgorithmItsVariants) {
  Table rows{"rows", columns_named("family,solver,kind,complete,problems,share,lower,upper,"
                                   "evaluations")};
  rows.add("all", "fireworks", "fireworks", true, 9, 0.2, 0.1, 0.3, 5);
  rows.add("all", "bbfwa", "fireworks", true, 9, 0.4, 0.3, 0.5, 5);
  rows.add("all", "random-search", "chance", true, 9, 0.05, 0.01, 0.09, 5);
  rows.add("all", "some", "other", false, 5, 0.9, 0.8, 1, 5);
  rows.add("all", "fireworks-corrected", "fireworks", true, 9, 0.3, 0.2, 0.4, 5);
  const Table kinds = kind_table(rows);
  EXPECT_THAT(rows_of(kinds, "best,solvers"), ElementsAre("bbfwa | 3", "random-search | 1"));
  EXPECT_EQ(
      paper_algorithm_sentence(rows),
      "The paper's algorithm (fireworks) is better than random search on the families that "
      "most solvers take (9 problems): it solves 20 % [10, 30] of the runs, random search 5 % "
      "[1, 9]. Of its 2 variants fireworks-corrected solves most, 30 % [20, 40].");
  EXPECT_FALSE(paper_algorithm_sentence(where(rows, "kind", std::string("fireworks"))).has_value());
}

TEST(Profiles, AreOfTheRatiosToTheLeast) {
  const MadeUp made(two_runs(both_bowls), usual_runs);
  report::Results page;
  add_profiles(made.campaign, made.sets().at(0), page);
  // Expected running times: 110 and 20 of chance-a, 50 and 25 of chance-b.
  const Table& table = *page.table("profile");
  EXPECT_THAT(rows_of(table, "solver,least,twice,tenfold,solved"),
              ElementsAre("chance-b | 0.5 | 1 | 1 | 1", "chance-a | 0.5 | 0.5 | 1 | 1",
                          "luck | 0 | 0 | 0 | 0"));
  // PAR10: (10 + 1000) / 2 and 20; 50 and 25; the least of both 50 and 20.
  EXPECT_NEAR(table[1].number("cost"), std::sqrt(505.0 * 20), 1e-9);
  EXPECT_NEAR(table[0].number("gap"), std::sqrt(1250.0 / 1000.0), 1e-9);
  EXPECT_EQ(page.chart("profile")->series.size(), 3U);
  EXPECT_EQ(page.chart("profile")->series[0].samples.front().value, 50);
}

TEST(Ecdf, HasTheEndsAloneOfLevelParts) {
  const MadeUp made(two_runs(both_bowls, "chance-*"), usual_runs);
  const auto parts = made.rated();
  const std::vector<Rating>& ratings = parts.at(0).most(0);
  const report::Chart chart = runtime_ecdf("bowl", 100, ratings);
  ASSERT_EQ(chart.series.size(), 2U);
  for (const std::size_t s : {0U, 1U}) {
    const auto& samples = chart.series[s].samples;
    EXPECT_EQ(samples.front().value, 0);
    EXPECT_NEAR(*samples.back().value, 100 * ratings[s].progress.back().share, 1e-9);
    for (std::size_t i = 2; i < samples.size(); ++i) {
      EXPECT_FALSE(samples[i].value == samples[i - 1].value &&
                   samples[i].value == samples[i - 2].value);
    }
  }
}

/// A run that solved its problem with the last of what it asked for, or not at all.
Outcome asking_run(std::int64_t values, std::int64_t derivatives, double seconds,
                   bool solved = true) {
  const std::int64_t evaluations = values + derivatives;
  Outcome outcome = run_of(solved ? std::optional(evaluations) : std::nullopt);
  outcome.evaluations = evaluations;
  outcome.values = values;
  outcome.derivatives = derivatives;
  outcome.seconds = seconds;
  outcome.verdict.seconds_to_solve = seconds;
  return outcome;
}

/// On problems of one and of two variables chance-a has `a` as its only run, chance-b `b`; luck
/// never solves anything.
Table ranges_of(const Outcome& a, const Outcome& b) {
  const Outcome nothing = asking_run(100, 0, 0.1, false);
  const MadeUp made(part_of(both_bowls, "solvers = \"*\"\nbudgets = [100]\ninstances = 1"),
                    [&](const PlannedCell& cell) {
                      const std::string& solver = cell.cell.solver;
                      return std::vector{solver == "luck" ? nothing : solver == "chance-a" ? a : b};
                    });
  EXPECT_EQ(made.sets().size(), 1U);
  report::Results page;
  add_break_even(made.campaign, made.sets().at(0), page);
  // A millisecond an evaluation; one of the second problem takes two simulations.
  EXPECT_NEAR(number_in(*page.value("here")).value_or(0), 1e-3 / std::sqrt(2.0), 1e-12);
  return *page.table("break-even");
}

// A asks for 100 values, a millisecond each; B for 10, and computes for the rest of a second. For
// each variable, mean over both problems: 100 against 10 simulations, 0.7425 s of computing.
TEST(BreakEven, IsWhereComputingLessAndAskingLessTakeAsLong) {
  const Table rows = ranges_of(asking_run(100, 0, 0.1), asking_run(10, 0, 1));
  for (const std::string price : {"0", "measured", "n"}) {
    const Table some = where(rows, "price", price);
    const double until = some[0].number("until");
    EXPECT_NEAR(until, 0.7425 / 90, 1e-8);
    EXPECT_THAT(rows_of(some, "solver,from,until"),
                ElementsAre(fmt::format("chance-a | - | {}", until),
                            fmt::format("chance-b | {} | -", until)));
    EXPECT_EQ(some[1].number("sure"), 1) << "on both problems the same is ahead";
  }
}

TEST(BreakEven, DependsOnThePriceOfAGradientAndOnWhatIsAskedUntilARunSolves) {
  const auto ahead = [](const Table& rows, const std::string& price) {
    return rows_of(where(rows, "price", price), "solver,until");
  };
  // 100 values against 60 with a gradient each: at n 60 + 60 simulations for one variable, 60 + 120
  // for each of two.
  const Table rows = ranges_of(asking_run(100, 0, 0.1), asking_run(60, 60, 1));
  EXPECT_THAT(ahead(rows, "0"), ElementsAre(_, "chance-b | -"));
  EXPECT_THAT(ahead(rows, "n"), ElementsAre("chance-a | -"));
  // It solves half way: what it asks for later is not its cost.
  Outcome half = asking_run(100, 0, 0.1);
  half.verdict.evaluations_to_solve = 5;
  half.verdict.seconds_to_solve = 0.005;
  EXPECT_THAT(ahead(ranges_of(half, asking_run(10, 0, 1)), "n"), ElementsAre("chance-a | -"));
}

TEST(OwnSolver, StandsBesideTheOthersOfItsFamilyUnlessItIsOfTheSuite) {
  // Of eight bowls "weak" never solves any, "mine" and "equal" all, and "strong" not the first.
  const auto runs_of = [](const PlannedCell& cell) {
    const std::string& solver = cell.cell.solver;
    const bool fails = solver == "weak" || (solver == "strong" && cell.cell.problem == "bowl-1");
    return twice(fails ? run_of({}) : run_of(100));
  };
  const MadeUp made(part_of("\"*\"", "solvers = [\"*\", \"./mine\"]\nbudgets = 100\ninstances = 2"),
                    runs_of, bowls_and(8, {"weak", "equal", "strong"}));
  std::vector<Solver> suite = {chance("weak"), chance("equal"), chance("strong")};
  report::Results page, none;
  add_own_solvers(made.campaign, made.sets(), suite, page);
  // Of weak eight of eight problems differ, of strong one.
  EXPECT_THAT(
      rows_of(*page.table("own-solvers"), "solver,family,share,rivals,better,worse,clearly_better"),
      ElementsAre("mine | bowl | 1 | 3 | 2 | 0 | 1"));
  EXPECT_LT((*page.table("own-solvers"))[0].number("lower"), 0.9);
  EXPECT_THAT(rows_of(*page.table("own-totals"), "solved,problems"), ElementsAre("8 | 8"));
  suite.push_back(chance("mine"));
  add_own_solvers(made.campaign, made.sets(), suite, none);
  EXPECT_TRUE(none.table("own-solvers")->rows.empty());
  EXPECT_TRUE(none.table("own-totals")->rows.empty());
}

TEST(Ends, AreNamedByWhatHappened) {
  Outcome outcome;
  outcome.evaluations = 10;
  EXPECT_EQ(kind_of_end(outcome, 100), "nothing feasible");
  outcome.verdict.feasible = true;
  EXPECT_EQ(kind_of_end(outcome, 100), "gave up early");
  EXPECT_EQ(kind_of_end(outcome, 10), "budget spent");
  outcome.verdict.solved = true;
  EXPECT_EQ(kind_of_end(outcome, 10), "evaluated, not returned");
  outcome.failure = "crashed: signal 11";
  EXPECT_EQ(kind_of_end(outcome, 10), "killed or crashed");
  outcome.failure = "an evaluation failed";
  EXPECT_EQ(kind_of_end(outcome, 10), "threw");
  outcome.verdict.returned_solved = true;
  EXPECT_EQ(kind_of_end(outcome, 10), "solved");
}

// Both take both; "b" solves most runs in the one, "a" nothing in either; "c" takes one alone.
TEST(Formulations, AreComparedOverTheSolversThatTakeSeveral) {
  const auto rated = [](const char* solver, const char* formulation, double returned) {
    Rating rating;
    rating.solver = solver;
    rating.formulation = formulation;
    rating.returned = returned;
    return rating;
  };
  const Table table = formulation_table({rated("b", "count", 0.2), rated("a", "count", 0),
                                         rated("b", "penalised", 0.8), rated("a", "penalised", 0),
                                         rated("c", "count", 1)});
  EXPECT_THAT(rows_of(table, "formulation,solvers,mean,most,best"),
              ElementsAre("penalised | 2 | 0.4 | 0.8 | 1", "count | 2 | 0.1 | 0.2 | 0"))
      << "best of b; a solves nothing in any";
}

}  // namespace
}  // namespace ricochet::studies::comparison
