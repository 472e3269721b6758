#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/family.h"
#include "src/analysis/comparison/profiles.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

/// A run of 100 evaluations that solved after so many, or not at all.
Outcome run_solved_after(std::optional<std::int64_t> solved) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.seconds = 2;
  outcome.verdict.solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  if (solved) outcome.verdict.seconds_to_solve = 0.01 * static_cast<double>(*solved);
  outcome.verdict.returned_solved = outcome.verdict.solved;
  outcome.verdict.optimality_gap = solved ? 0.0 : 3.0;
  outcome.verdict.returned_optimality_gap = outcome.verdict.optimality_gap;
  outcome.steps = {{solved.value_or(50), 0.1, *outcome.verdict.optimality_gap}};
  return outcome;
}

Campaign campaign_of(const std::string& problems, const std::string& solvers) {
  return Campaign(plan_from("name = \"t\"\n[[part]]\nproblems = [" + problems + "]\nsolvers = [" +
                                solvers + "]\nbudgets = [100]\ninstances = 2\n",
                            "test"),
                  made_up_catalogue());
}

/// All cells with two runs each: chance-a solves one of the first problem after 10 evaluations,
/// and both of others after 40; chance-b all after 50; luck none.
std::vector<CellResult> results_of(const Campaign& campaign) {
  return made_up_results(campaign, [](const PlannedCell& cell) {
    if (cell.cell.solver == "luck") return std::vector{run_solved_after({}), run_solved_after({})};
    if (cell.cell.solver == "chance-b") {
      return std::vector{run_solved_after(50), run_solved_after(50)};
    }
    return cell.cell.problem == "bowl-1" ? std::vector{run_solved_after(10), run_solved_after({})}
                                         : std::vector{run_solved_after(40), run_solved_after(40)};
  });
}

std::vector<EntrySet> entry_sets_of(const Campaign& campaign,
                                    const std::vector<CellResult>& results) {
  return comparison::entry_sets_of(campaign, results, reported_parts(campaign));
}

Row row_of(const Table& rows, const std::string& solver) {
  return rows.find([&](const Row& row) { return row.text("solver") == solver; }).value();
}

TEST(SpeedAccuracy, IsWhatTheRunsCountUpTo) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  const auto results = results_of(campaign);
  const Table table = speed_accuracy_table(campaign, entry_sets_of(campaign, results));
  ASSERT_EQ(table.rows.size(), 3U);
  const Row a = row_of(table, "chance-a");
  // 10 and 100 of one variable; 40 and 40 of two.
  EXPECT_NEAR(a.number("evaluations"), std::sqrt(55.0 * 20.0), 1e-9);
  EXPECT_NEAR(a.number("seconds"), std::sqrt((0.1 + 2) / 2 * 0.4), 1e-9);
  EXPECT_EQ(a.number("share"), 0.75);
  EXPECT_LT(a.number("lower"), 0.75);
  EXPECT_GT(a.number("upper"), 0.75);
  EXPECT_EQ(a.number("runs"), 4);
  EXPECT_EQ(a.number("part"), 1);
  EXPECT_TRUE(a.is("complete"));
  const Row b = row_of(table, "chance-b");
  EXPECT_NEAR(b.number("evaluations"), std::sqrt(50.0 * 25.0), 1e-9);
  EXPECT_EQ(b.number("share"), 1);
  EXPECT_TRUE(a.is("on_front"));
  EXPECT_TRUE(b.is("on_front"));
  EXPECT_FALSE(row_of(table, "luck").is("on_front"));
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
}

TEST(SpeedAccuracy, LeavesWhoTakesSomeOnlyOffTheFront) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  auto results = results_of(campaign);
  std::erase_if(results, [](const CellResult& s) {
    return s.cell->cell.solver == "chance-a" && s.cell->cell.problem == "bowl-1";
  });
  const Table rows = speed_accuracy_table(campaign, entry_sets_of(campaign, results));
  EXPECT_FALSE(row_of(rows, "chance-a").is("complete"));
  EXPECT_FALSE(row_of(rows, "chance-a").is("on_front"));
  EXPECT_TRUE(row_of(rows, "chance-b").is("on_front"));
}

TEST(SpeedAccuracy, JoinsFamiliesOfWhichEachSolverTakesAll) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"cup-s\"", "\"*\"");
  const auto results = results_of(campaign);
  const Table table = speed_accuracy_table(campaign, entry_sets_of(campaign, results));
  EXPECT_EQ(table[0].text("family"), "all");
  EXPECT_TRUE(is_missing(table[0]["budget"]));
  EXPECT_EQ(table[0].text("solver"), "chance-a");
  EXPECT_EQ(table[0].number("share"), 0.75);
}

TEST(SpeedAccuracy, OfNothingOrOneIsNothingOrOne) {
  const Campaign campaign = campaign_of("\"bowl-1\"", "\"luck\"");
  EXPECT_TRUE(speed_accuracy_table(campaign, {}).rows.empty());
  const auto results = results_of(campaign);
  const auto sets = entry_sets_of(campaign, results);
  const Table one = speed_accuracy_table(campaign, sets);
  ASSERT_EQ(one.rows.size(), 1U);
  EXPECT_EQ(one[0].number("share"), 0);
  EXPECT_FALSE(sets[0].compared());
}

TEST(Kinds, HaveTheirBestAndThePapersAlgorithmItsVariants) {
  Table rows{"rows",
             {{"family"},
              {"solver"},
              {"kind"},
              {"complete"},
              {"problems"},
              {"share"},
              {"lower"},
              {"upper"},
              {"evaluations"}}};
  rows.add("all", "fireworks", "fireworks", true, 9, 0.2, 0.1, 0.3, 5);
  rows.add("all", "bbfwa", "fireworks", true, 9, 0.4, 0.3, 0.5, 5);
  rows.add("all", "random-search", "chance", true, 9, 0.05, 0.01, 0.09, 5);
  rows.add("all", "some", "other", false, 5, 0.9, 0.8, 1, 5);
  rows.add("all", "fireworks-corrected", "fireworks", true, 9, 0.3, 0.2, 0.4, 5);
  const Table kinds = kind_table(rows);
  ASSERT_EQ(kinds.rows.size(), 2U);
  EXPECT_EQ(kinds[0].text("best"), "bbfwa");
  EXPECT_EQ(kinds[0].number("solvers"), 3);
  EXPECT_EQ(kinds[1].text("best"), "random-search");
  EXPECT_EQ(
      paper_algorithm_sentence(rows),
      "The paper's algorithm (fireworks) is better than random search on the families that "
      "most solvers take (9 problems): it solves 20 % [10, 30] of the runs, random search 5 % "
      "[1, 9]. Of its 2 variants fireworks-corrected solves most, 30 % [20, 40].");
  EXPECT_FALSE(paper_algorithm_sentence(where(rows, "kind", std::string("fireworks"))).has_value());
}

TEST(Profiles, AreOfTheRatiosToTheLeast) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  const auto results = results_of(campaign);
  report::Results page;
  add_profiles(campaign, entry_sets_of(campaign, results).at(0), page);
  // Expected running times: 110 and 20 of chance-a, 50 and 25 of chance-b.
  const Table& table = *page.table("profile");
  const Row a = row_of(table, "chance-a"), b = row_of(table, "chance-b");
  EXPECT_EQ(a.number("least"), 0.5);
  EXPECT_EQ(a.number("twice"), 0.5);
  EXPECT_EQ(a.number("tenfold"), 1);
  EXPECT_EQ(b.number("twice"), 1);
  EXPECT_EQ(row_of(table, "luck").number("solved"), 0);
  // PAR10: (10 + 1000) / 2 and 20; 50 and 25; the least of both 50 and 20.
  EXPECT_NEAR(a.number("cost"), std::sqrt(505.0 * 20), 1e-9);
  EXPECT_EQ(table[0].text("solver"), "chance-b");
  EXPECT_NEAR(table[0].number("gap"), std::sqrt(1250.0 / 1000.0), 1e-9);
  EXPECT_EQ(page.chart("profile")->series.size(), 3U);
  EXPECT_EQ(page.chart("profile")->series[0].samples.front().value, 50);
}

TEST(Ecdf, HasTheEndsAloneOfLevelParts) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"chance-*\"");
  const auto results = results_of(campaign);
  const auto reported = reported_parts(campaign);
  const auto parts = rated_parts(campaign, results, reported);
  const report::Chart chart = runtime_ecdf("bowl", 100, parts.at(0).most(0));
  ASSERT_EQ(chart.series.size(), 2U);
  for (const report::Series& series : chart.series) {
    const auto& samples = series.samples;
    EXPECT_EQ(samples.front().value, 0);
    EXPECT_NEAR(*samples.back().value,
                100 * parts[0].most(0)[&series - chart.series.data()].progress.back().share, 1e-9);
    for (std::size_t i = 2; i < samples.size(); ++i) {
      EXPECT_FALSE(samples[i].value == samples[i - 1].value &&
                   samples[i].value == samples[i - 2].value);
    }
  }
}

/// A run that solved its problem with the last of what it asked for, or not at all.
Outcome asking_run(std::int64_t values, std::int64_t derivatives, double seconds,
                   bool solved = true) {
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
Table ranges_of(const Outcome& a, const Outcome& b) {
  const Campaign campaign(
      plan_from("name = \"t\"\n[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"*\"]\n"
                "budgets = [100]\ninstances = 1\n",
                "test"),
      made_up_catalogue());
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    const std::string& solver = cell.cell.solver;
    return std::vector{solver == "luck" ? asking_run(100, 0, 0.1, false)
                                        : (solver == "chance-a" ? a : b)};
  });
  const auto sets = entry_sets_of(campaign, results);
  EXPECT_EQ(sets.size(), 1U);
  report::Results page;
  add_break_even(campaign, sets.at(0), page);
  // A millisecond an evaluation; one of the second problem takes two simulations.
  EXPECT_NEAR(number_in(*page.value("here")).value_or(0), 1e-3 / std::sqrt(2.0), 1e-12);
  return *page.table("break-even");
}

Table at_price(const Table& rows, const std::string& price) {
  return where(rows, "price", price);
}

// A asks for 100 values, a millisecond each; B for 10, and computes for the rest of a second. For
// each variable, mean over both problems: 100 against 10 simulations, 0.7425 s of computing.
TEST(BreakEven, IsWhereComputingLessAndAskingLessTakeAsLong) {
  const Table rows = ranges_of(asking_run(100, 0, 0.1), asking_run(10, 0, 1));
  for (const std::string price : {"0", "measured", "n"}) {
    const auto some = at_price(rows, price);
    ASSERT_EQ(some.rows.size(), 2) << price;
    EXPECT_EQ(some[0].text("solver"), "chance-a");
    EXPECT_TRUE(is_missing(some[0]["from"]));
    EXPECT_NEAR(some[0].number("until"), 0.7425 / 90, 1e-8);
    EXPECT_EQ(some[1].text("solver"), "chance-b");
    EXPECT_EQ(some[1]["from"], some[0]["until"]);
    EXPECT_TRUE(is_missing(some[1]["until"]));
    EXPECT_EQ(some[1].number("sure"), 1) << "on both problems the same is ahead";
  }
}

// 100 values against 60 with a gradient each: at n 60 + 60 simulations for one variable, 60 + 120
// for each of two.
TEST(BreakEven, DependsOnThePriceOfAGradient) {
  const Table rows = ranges_of(asking_run(100, 0, 0.1), asking_run(60, 60, 1));
  const auto free = at_price(rows, "0");
  ASSERT_EQ(free.rows.size(), 2);
  EXPECT_EQ(free[1].text("solver"), "chance-b");
  const auto dear = at_price(rows, "n");
  ASSERT_EQ(dear.rows.size(), 1);
  EXPECT_EQ(dear[0].text("solver"), "chance-a");
  EXPECT_TRUE(is_missing(dear[0]["until"]));
}

// It solves half way: what it asks for later is not its cost.
TEST(BreakEven, CountsARunUntilItSolves) {
  Outcome half = asking_run(100, 0, 0.1);
  half.verdict.evaluations_to_solve = 5;
  half.verdict.seconds_to_solve = 0.005;
  const Table rows = ranges_of(half, asking_run(10, 0, 1));
  ASSERT_EQ(at_price(rows, "n").rows.size(), 1);
  EXPECT_EQ(at_price(rows, "n")[0].text("solver"), "chance-a");
}

constexpr int own_bowls = 8;

/// A family of eight bowls, which "weak" never solves, "mine" always, "equal" too, and "strong" not
/// the first of them.
report::Results own_page(const std::vector<Solver>& suite) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {}}};
  for (int k = 1; k <= own_bowls; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  catalogue.solvers = {chance("weak"), chance("equal"), chance("strong")};
  const Campaign campaign(plan_from("[[part]]\nproblems = \"*\"\nsolvers = [\"*\", \"./mine\"]\n"
                                    "budgets = 100\ninstances = 2\n",
                                    "test"),
                          catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    Outcome outcome;
    outcome.evaluations = 100;
    outcome.verdict.returned_solved =
        cell.cell.solver != "weak" &&
        !(cell.cell.solver == "strong" && cell.cell.problem == "bowl-1");
    return std::vector{outcome, outcome};
  });
  report::Results page;
  add_own_solvers(campaign, entry_sets_of(campaign, results), suite, page);
  return page;
}

TEST(OwnSolver, StandsBesideTheOthersOfItsFamily) {
  const report::Results data = own_page({chance("weak"), chance("equal"), chance("strong")});
  const Table& rows = *data.table("own-solvers");
  ASSERT_EQ(rows.rows.size(), 1U);
  const Row row = rows[0];
  EXPECT_EQ(row.text("solver"), "mine");
  EXPECT_EQ(row.text("family"), "bowl");
  EXPECT_EQ(row.number("share"), 1.0);
  EXPECT_LT(row.number("lower"), 0.9);
  EXPECT_EQ(row.number("rivals"), 3);
  EXPECT_EQ(row.number("better"), 2) << "weak and strong";
  EXPECT_EQ(row.number("worse"), 0);
  EXPECT_EQ(row.number("clearly_better"), 1) << "weak: eight of eight differ; strong: one";
  const Row total = (*data.table("own-totals"))[0];
  EXPECT_EQ(total.number("solved"), own_bowls);
  EXPECT_EQ(total.number("problems"), own_bowls);
}

TEST(OwnSolver, IsNoneOfTheSuite) {
  const report::Results data =
      own_page({chance("weak"), chance("equal"), chance("strong"), chance("mine")});
  EXPECT_TRUE(data.table("own-solvers")->rows.empty());
  EXPECT_TRUE(data.table("own-totals")->rows.empty());
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
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table[0].text("formulation"), "penalised");
  EXPECT_EQ(table[0].number("solvers"), 2);
  EXPECT_DOUBLE_EQ(table[0].number("mean"), 0.4);
  EXPECT_EQ(table[0].number("most"), 0.8);
  EXPECT_EQ(table[0].number("best"), 1) << "of b; a solves nothing in any";
  EXPECT_EQ(table[1].number("best"), 0);
}

}  // namespace
}  // namespace ricochet::studies::comparison
