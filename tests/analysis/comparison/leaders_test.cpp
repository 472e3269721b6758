#include "src/analysis/comparison/leaders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/profiles.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

/// A run of 100 evaluations that evaluated a solving point after so many, or none, and returned it
/// or not.
Outcome run_of(std::optional<std::int64_t> after, bool returned = true) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.solved = after.has_value();
  outcome.verdict.returned_solved = after && returned;
  outcome.verdict.evaluations_to_solve = after;
  outcome.verdict.optimality_gap = after ? 0.0 : 1.0;
  outcome.verdict.returned_optimality_gap = outcome.verdict.returned_solved ? 0.0 : 1.0;
  outcome.steps = {{after.value_or(5), 0.1, *outcome.verdict.optimality_gap}};
  return outcome;
}

/// The leaders of two bowls, or of these problems, on which each solver has these two runs.
struct Led {
  explicit Led(const std::map<std::string, std::vector<Outcome>>& runs,
               const std::string& problems = "\"bowl-1\", \"bowl-2\"")
      : Led(plan_from("[[part]]\nproblems = [" + problems +
                          "]\nsolvers = \"*\"\nbudgets = [10, 100]\ninstances = 2\n",
                      "test"),
            catalogue(runs), [&](const PlannedCell& cell) { return runs.at(cell.cell.solver); }) {}

  Led(const Plan& plan, const Catalogue& catalogue,
      const std::function<std::vector<Outcome>(const PlannedCell&)>& runs_of)
      : campaign(plan, catalogue),
        results(made_up_results(campaign, runs_of)),
        reported(reported_parts(campaign)) {
    set_silent(campaign, results, reported);
    parts = rated_parts(campaign, results, reported);
  }

  static Catalogue catalogue(const std::map<std::string, std::vector<Outcome>>& runs) {
    Catalogue all = made_up_catalogue();
    all.solvers.clear();
    for (const auto& [name, of] : runs) all.solvers.push_back(chance(name));
    return all;
  }

  Campaign campaign;
  std::vector<CellResult> results;
  std::vector<ReportedPart> reported;
  std::vector<RatedPart> parts;
};

/// Two runs alike.
std::vector<Outcome> twice(const Outcome& outcome) {
  return {outcome, outcome};
}

TEST(Leaders, AreNamedWhereRandomSearchIsSlow) {
  for (const auto& random : {std::optional<std::int64_t>(21), std::optional<std::int64_t>()}) {
    const Led led({{"random-search", twice(run_of(random))}, {"fast", twice(run_of(1))}});
    const Table leaders = leader_table(led.parts);
    ASSERT_EQ(leaders.rows.size(), 2U);
    EXPECT_FALSE(leaders[0].is("largest"));
    EXPECT_TRUE(leaders[1].is("largest"));
    EXPECT_EQ(leaders[1].text("first"), "fast, original");
    EXPECT_EQ(leaders[1].text("family"), "bowl");
    EXPECT_EQ(leaders[1].number("budget"), 100);
    EXPECT_EQ(leaders[1].number("returned"), 1);
    EXPECT_EQ(leaders[1].number("best"), 1);
    EXPECT_EQ(leaders[1].number("problems"), 2);
    EXPECT_EQ(leaders[1].number_if("random"), random ? std::optional<double>(21) : std::nullopt);
    EXPECT_EQ(leaders[1].number("unsolved"), 0);
  }
}

TEST(Leaders, AreNotNamedWhereRandomSearchSolvesAtOnce) {
  const Led led({{"random-search", twice(run_of(20))}, {"fast", twice(run_of(1))}});
  const Table leaders = leader_table(led.parts);
  EXPECT_EQ(leaders[1].text("first"), "none named: random search needs 20 evaluations");
  EXPECT_TRUE(is_missing(leaders[1]["solver"]));
  EXPECT_TRUE(is_missing(leaders[1]["best"]));
}

TEST(Leaders, SayWhoSolvesMoreThanTheFirst) {
  // On one instance the fast one is first of six and solves; on the other all but the sure one
  // miss, and the fast one ties for the second place. The sure one comes last where all solve.
  std::map<std::string, std::vector<Outcome>> runs = {{"fast", {run_of(1), run_of({})}},
                                                      {"sure", twice(run_of(90))}};
  for (const char* other : {"a", "b", "c", "d"}) runs[other] = {run_of(50), run_of({})};
  const Led led(runs);
  const Table leaders = leader_table(led.parts);
  EXPECT_EQ(leaders[1].text("first"), "fast, original");
  EXPECT_EQ(leaders[1].text("most"), "sure, original: 100 %");
  const Led all({{"fast", {run_of(1), run_of(60)}}, {"sure", twice(run_of(50))}});
  EXPECT_TRUE(is_missing(leader_table(all.parts)[1]["most"])) << "the first solves all";
}

TEST(Leaders, SayThatTheFirstWasTunedToTheSuite) {
  const Led led({{"continuation-nlopt-slsqp", twice(run_of(10))}, {"b", twice(run_of(50))}});
  EXPECT_EQ(leader_table(led.parts)[1].text("tuned"), " (tuned to this suite)");
  const Led other({{"a", twice(run_of(10))}, {"b", twice(run_of(50))}});
  EXPECT_EQ(leader_table(other.parts)[1].text("tuned"), "");
}

TEST(Leaders, NameNobodyFirstWhereNobodySolvedARun) {
  const Led led({{"a", twice(run_of(10, false))}, {"b", twice(run_of({}))}});
  const Table leaders = leader_table(led.parts);
  EXPECT_EQ(leaders[1].text("first"), "none (the least mean rank solved no run)");
  EXPECT_TRUE(is_missing(leaders[1]["returned"]));
  EXPECT_EQ(leaders[1].number("unsolved"), 2);
}

TEST(Leaders, HaveNoProbabilityOnOneProblem) {
  const Led led({{"a", twice(run_of(10))}, {"b", twice(run_of({}))}}, "\"bowl-1\"");
  EXPECT_EQ(leader_table(led.parts)[1].text("solver"), "a");
  EXPECT_TRUE(is_missing(leader_table(led.parts)[1]["best"]));
}

/// The table of the silent problems of two bowls.
Table silent_of(const std::map<std::string, std::vector<Outcome>>& of_first,
                const std::map<std::string, std::vector<Outcome>>& of_second, Table* leaders) {
  const Led led(
      plan_from("[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = \"*\"\n"
                "budgets = 100\ninstances = 2\n",
                "test"),
      Led::catalogue(of_first), [&](const PlannedCell& cell) {
        return (cell.cell.problem == "bowl-1" ? of_first : of_second).at(cell.cell.solver);
      });
  if (leaders) *leaders = leader_table(led.parts);
  return silent_table(led.campaign, led.results, led.reported);
}

TEST(Silent, IsAProblemThatNobodySolvedAndOneThatRandomSearchSolvesAtOnce) {
  const std::map<std::string, std::vector<Outcome>> told = {
      {"random-search", twice(run_of(50))}, {"a", twice(run_of(10))}, {"b", twice(run_of(30))}};
  std::map<std::string, std::vector<Outcome>> unsolved, easy;
  for (const auto& [name, runs] : told) {
    unsolved[name] = {run_of({}), run_of(99, false)};
    easy[name] = twice(run_of(name == "b" ? 1 : 9));
  }
  Table leaders;
  const Table none = silent_of(told, told, &leaders);
  EXPECT_TRUE(none.rows.empty());
  EXPECT_EQ(leaders[0].number("problems"), 2);
  EXPECT_EQ(leaders[0].number("left_out"), 0);
  for (const bool is_easy : {false, true}) {
    const Table silent = silent_of(told, is_easy ? easy : unsolved, &leaders);
    ASSERT_EQ(silent.rows.size(), 1U);
    EXPECT_EQ(silent[0].text("problem"), "bowl-2");
    EXPECT_EQ(silent[0].number("entries"), 3);
    EXPECT_EQ(silent[0].number("runs"), 6);
    EXPECT_EQ(silent[0].is("unsolved"), !is_easy);
    EXPECT_TRUE(silent[0].is("left_out"));
    if (!is_easy) {
      EXPECT_DOUBLE_EQ(silent[0].number("gap"), 1 / bowl("bowl-2", 1).tolerance);
    }
    EXPECT_EQ(leaders[0].number("problems"), 1) << "the other is ranked alone";
    EXPECT_EQ(leaders[0].number("left_out"), 1);
    EXPECT_EQ(leaders[0].number("unsolved"), is_easy ? 0 : 1);
    EXPECT_EQ(leaders[0].text("solver"), "a");
    EXPECT_EQ(leaders[0].number("returned"), 1);
  }
  const Table all = silent_of(unsolved, easy, nullptr);
  ASSERT_EQ(all.rows.size(), 2U);
  EXPECT_FALSE(all[0].is("left_out")) << "nothing would be left";
}

/// A solver that asks for gradients.
Solver steep(const std::string& name) {
  Solver solver = chance(name);
  solver.capabilities.derivatives = Capabilities::Order::gradient;
  return solver;
}

/// Bowls of 2 to 5 variables, each twice in a cluster, with gradients that cost one evaluation.
Catalogue steep_bowls() {
  Catalogue all = made_up_catalogue();
  all.families = {{"bowl", {}}};
  for (int n = 2; n <= 5; ++n) {
    for (const char* twin : {"a", "b"}) {
      Problem problem = bowl("bowl-" + std::to_string(n) + twin, n);
      problem.cluster = std::to_string(n);
      problem.gradient_cost = 1;
      problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
        return Derivatives{evaluate(x), Vector::Zero(x.size()), Matrix(0, x.size())};
      };
      all.families[0].problems.push_back(problem);
    }
  }
  all.solvers = {chance("values"), steep("gradients"), chance("slow")};
  return all;
}

constexpr const char* two_prices =
    "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 2\n"
    "gradient_prices = [\"measured\", \"n\"]\n";

TEST(Leaders, AreNamedAtBothPricesOfAGradient) {
  const Led led(plan_from(two_prices, "test"), steep_bowls(), [](const PlannedCell& cell) {
    if (cell.cell.solver == "slow") return twice(run_of(90));
    if (cell.cell.solver == "values") return twice(run_of(40));
    return twice(run_of(cell.cell.gradient_price == "n" ? 60 : 30));
  });
  ASSERT_EQ(led.campaign.cells().size(), 8U * 4) << "values are run once, at one price";
  const Table leaders = leader_table(led.parts);
  ASSERT_EQ(leaders.rows.size(), 1U);
  EXPECT_EQ(leaders[0].text("first"), "gradients, original");
  EXPECT_EQ(leaders[0].text("differences_first"), "values, original");
  EXPECT_EQ(leaders[0].number("differences_best"), 1);
  EXPECT_EQ(leaders[0].number("problems"), 8);
  EXPECT_EQ(leaders[0].number("clusters"), 4);
  EXPECT_TRUE(subset_table(led.parts).rows.empty()) << "the same are first everywhere";
}

TEST(Subsets, AreNumbersOfVariablesWithAnotherFirst) {
  const Led led(plan_from(two_prices, "test"), steep_bowls(), [](const PlannedCell& cell) {
    if (cell.cell.solver == "slow") return twice(run_of(90));
    const bool few = cell.cell.problem < "bowl-3";
    if (cell.cell.solver == "values") return twice(run_of(few ? 20 : 40));
    return twice(run_of(cell.cell.gradient_price == "n" ? 60 : 30));
  });
  const Table subsets = subset_table(led.parts);
  ASSERT_EQ(subsets.rows.size(), 4U);
  EXPECT_EQ(subsets[0].text("subset"), "2 variables");
  EXPECT_EQ(subsets[0].text("first"), "values, original");
  EXPECT_EQ(subsets[0].number("problems"), 2);
  EXPECT_EQ(subsets[0].number("clusters"), 1);
  EXPECT_TRUE(is_missing(subsets[0]["best"])) << "one cluster";
  EXPECT_EQ(subsets[3].text("subset"), "5 variables");
  EXPECT_EQ(subsets[3].text("first"), "gradients, original");
  EXPECT_EQ(subsets[3].text("differences_first"), "values, original");
}

TEST(Subsets, AreTheStartsAtEachDistance) {
  Catalogue catalogue = steep_bowls();
  for (Problem& problem : catalogue.families[0].problems) problem.start_scales = {1, 10};
  const Led led(plan_from(two_prices, "test"), catalogue, [](const PlannedCell& cell) {
    if (cell.cell.solver == "slow") return twice(run_of(90));
    if (cell.cell.solver == "values") return std::vector{run_of(20), run_of({})};
    return std::vector{run_of(50), run_of(30)};
  });
  const Table subsets = subset_table(led.parts);
  ASSERT_EQ(subsets.rows.size(), 2U);
  EXPECT_EQ(subsets[0].text("subset"), "from the published start");
  EXPECT_EQ(subsets[0].text("first"), "values, original");
  EXPECT_EQ(subsets[1].text("subset"), "from 10 times the start");
  EXPECT_EQ(subsets[1].text("first"), "gradients, original");
  EXPECT_EQ(subsets[1].number("returned"), 1);
}

TEST(CoverageTable, TellsHowFarProblemsAreAlike) {
  const Led led(plan_from(two_prices, "test"), steep_bowls(), [](const PlannedCell& cell) {
    const bool solves = cell.cell.problem < "bowl-4" || cell.cell.solver == "slow";
    return twice(solves ? run_of(50) : run_of({}));
  });
  const Table rows = coverage_table(led.parts);
  ASSERT_EQ(rows.rows.size(), 1U);
  EXPECT_EQ(rows[0].number("clusters"), 4);
  EXPECT_LT(rows[0].number("effective"), 4);
  EXPECT_GT(rows[0].number("coverage"), rows[0].number("ignoring"));
}

/// A run that returned a point of this objective and violation.
Outcome returned(double objective, double violation) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.returned = TrueValues{objective, violation};
  if (violation <= 0) {
    outcome.verdict.returned_optimality_gap = objective;
    outcome.steps = {{1, 0, 1}, {60, 0, objective}};
  }
  return outcome;
}

TEST(MeritGap, OfAnInfeasiblePointHasItsViolation) {
  Problem problem = bowl("bowl-1", 1);
  problem.best_known = 2;
  problem.penalty_weight = 100;
  EXPECT_EQ(merit_gap(problem, returned(5, 0)), 3);
  EXPECT_EQ(merit_gap(problem, returned(5, 0.5)), 53);
  EXPECT_EQ(merit_gap(problem, returned(-7, 0.5)), 50) << "what is infeasible is not better";
  EXPECT_TRUE(std::isinf(merit_gap(problem, returned(std::nan(""), 0))));
  EXPECT_TRUE(std::isinf(merit_gap(problem, Outcome())));
}

TEST(Accuracy, IsTheShareOfTheStartsGapThatIsLeft) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {bowl("bowl-1", 1), bowl("bowl-2", 1)}}};
  catalogue.solvers = {chance("near"), chance("far")};
  const double start = true_values_at(instance(catalogue.families[0].problems[0], 1),
                                      instance(catalogue.families[0].problems[0], 1).start)
                           .objective;
  const Led led(
      plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"*\"\n"
                "budgets = 100\ninstances = 1\n",
                "test"),
      catalogue, [&](const PlannedCell& cell) {
        return std::vector{returned(start * (cell.cell.solver == "near" ? 5e-4 : 0.5), 0)};
      });
  report::Results page;
  add_accuracy(led.parts[0], 0, page);
  const auto& precisions = page.parts.at("precisions");
  ASSERT_EQ(precisions.size(), 4U);
  EXPECT_EQ(precisions[0].id, "1e-1");
  const Table& loose = *precisions[0].results.table("accuracy");
  EXPECT_EQ(loose[0].text("solver"), "near");
  EXPECT_EQ(loose[0].number("share"), 1);
  EXPECT_EQ(loose[1].number("share"), 0);
  EXPECT_EQ((*precisions[1].results.table("accuracy"))[0].number("share"), 1) << "5e-4 <= 1e-3";
  EXPECT_EQ((*precisions[2].results.table("accuracy"))[0].number("share"), 0);
  const report::Chart* profile = precisions[1].results.charts.data();
  const auto& samples = profile->series[0].samples;
  for (const auto& sample : samples) EXPECT_EQ(sample.value, sample.position >= 60 ? 100 : 0);
}

}  // namespace
}  // namespace ricochet::studies::comparison
