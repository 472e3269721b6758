#include "src/analysis/comparison/order.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/family.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

/// A campaign of seven solvers on two bowls, which they solve after so many evaluations.
struct TwoBowls {
  explicit TwoBowls(const std::function<int(int solver)>& evaluations)
      : campaign(plan_from("[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = \"s*\"\n"
                           "budgets = 100\ninstances = 2\n",
                           "test"),
                 catalogue()),
        results(made_up_results(campaign, [&](const PlannedCell& cell) {
          Outcome outcome;
          const int after = evaluations(std::stoi(cell.cell.solver.substr(1)));
          outcome.evaluations = 100;
          outcome.verdict.solved = outcome.verdict.returned_solved = after < 100;
          outcome.verdict.evaluations_to_solve = after;
          outcome.verdict.optimality_gap = outcome.verdict.returned_optimality_gap =
              after < 100 ? 0 : 1;
          outcome.steps = {{after, 0, *outcome.verdict.optimality_gap}};
          return std::vector{outcome, outcome};
        })) {}

  static Catalogue catalogue() {
    Catalogue all = made_up_catalogue();
    all.solvers.clear();
    for (int s = 0; s < 7; ++s) all.solvers.push_back(chance("s" + std::to_string(s)));
    return all;
  }

  Campaign campaign;
  std::vector<CellResult> results;
};

FamilyAgreement agreement_with(const TwoBowls& first, const TwoBowls& second) {
  return family_agreements(first.campaign, first.results, second.campaign, second.results).at(0);
}

TEST(AgreementOfCampaigns, IsOneForTheSameOrderAndMinusOneForTheOpposite) {
  const TwoBowls rising([](int s) { return 10 + s; });
  const FamilyAgreement same = agreement_with(rising, TwoBowls([](int s) { return 20 + 2 * s; }));
  EXPECT_EQ(same.family, "bowl");
  EXPECT_NEAR(same.agreement->correlation, 1, 1e-12);
  EXPECT_EQ(same.leader, "s0, original");
  EXPECT_EQ(same.place, 1);
  EXPECT_EQ(same.best, 1.0);
  const FamilyAgreement opposite = agreement_with(rising, TwoBowls([](int s) { return 90 - s; }));
  EXPECT_NEAR(opposite.agreement->correlation, -1, 1e-12);
  EXPECT_EQ(opposite.place, 7);
  EXPECT_EQ(opposite.other_leader, "s6, original");
}

TEST(AgreementOfCampaigns, HasNoLeaderWhereNothingIsSolved) {
  const FamilyAgreement row =
      agreement_with(TwoBowls([](int) { return 100; }), TwoBowls([](int s) { return 10 + s; }));
  EXPECT_EQ(row.leader, "none");
  EXPECT_FALSE(row.best.has_value());
  EXPECT_FALSE(row.place.has_value());
  EXPECT_FALSE(row.agreement.has_value()) << "all are tied";
}

/// Two bowls; the runs of "bowl-1" end with these optimality gaps, those of "bowl-2" with 0.
Table beaten_by(const std::vector<std::optional<double>>& gaps) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {bowl("bowl-1", 1), bowl("bowl-2", 1)}}};
  catalogue.solvers = {chance("guess")};
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 1\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    std::vector<Outcome> outcomes;
    for (const auto& gap : gaps) {
      Outcome outcome;
      outcome.verdict.optimality_gap = cell.cell.problem == "bowl-1" ? gap : 0;
      outcomes.push_back(outcome);
    }
    return outcomes;
  });
  return beaten_table(campaign, results);
}

TEST(Beaten, BestValuesAreThoseBelowWhichARunEndsByMoreThanTheTolerance) {
  const double tolerance = bowl("bowl-1", 1).tolerance;
  const Table rows = beaten_by({0.5, -1.5 * tolerance, std::nullopt, -3 * tolerance});
  ASSERT_EQ(rows.rows.size(), 1U);
  EXPECT_EQ(rows[0].text("problem"), "bowl-1");
  EXPECT_EQ(rows[0].number("runs"), 2);
  EXPECT_EQ(rows[0].number("gap"), -3 * tolerance);
  EXPECT_EQ(rows[0].text("entry"), "guess, original");
}

TEST(Beaten, NothingIsWithinTheTolerance) {
  EXPECT_TRUE(beaten_by({0, -0.9 * bowl("bowl-1", 1).tolerance, std::nullopt}).rows.empty());
}

const std::vector<MissingSolver> missing = {{"dlib-global-search", "dlib", {}},
                                            {"tao-brgn", "TAO", {}}};

std::vector<std::string> lacking_of(const std::string& solvers) {
  std::vector<std::string> names;
  const Plan plan =
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = [" + solvers + "]\nbudgets = 1\n", "test");
  for (const MissingSolver& one : lacking(plan, missing)) names.push_back(one.solver);
  return names;
}

TEST(Lacking, AreTheMissingSolversThatThePlanSelects) {
  EXPECT_EQ(lacking_of("\"*\""), (std::vector<std::string>{"dlib-global-search", "tao-brgn"}));
  EXPECT_EQ(lacking_of("\"mads\", \"tao-*\""), std::vector<std::string>{"tao-brgn"});
  EXPECT_TRUE(lacking_of("\"mads\"").empty());
}

TEST(Summary, CountsOrdersInWhichTheFirstStays) {
  const std::optional<double> none;
  Table orders{"orders", {{"family"}, {"changed"}, {"correlation"}, {"same"}}};
  orders.add("a", "seeds", 0.5, true);
  orders.add("b", "seeds", 0.1, false);
  orders.add("c", "seeds", 0.9, true);
  orders.add("c", "price", none, true);
  const Table summary = summary_of(orders, "summary", {"changed"});
  ASSERT_EQ(summary.rows.size(), 1U) << "the price is compared with nothing";
  EXPECT_EQ(summary[0].number("compared"), 3);
  EXPECT_EQ(summary[0].number("stays"), 2);
  EXPECT_EQ(summary[0].number("median"), 0.5);
  EXPECT_EQ(summary[0].number("least"), 0.1);
}

/// Bowls and as many solvers as asked for; the k-th solves every problem after k evaluations.
Table held_out_of(int problems, int solvers) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.solvers.clear();
  for (int k = 1; k <= solvers; ++k) catalogue.solvers.push_back(chance("s" + std::to_string(k)));
  catalogue.families = {{"bowl", {}}};
  for (int k = 1; k <= problems; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 1\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    Outcome outcome;
    outcome.evaluations = 100;
    outcome.verdict.solved = outcome.verdict.returned_solved = true;
    outcome.verdict.evaluations_to_solve = std::stoi(cell.cell.solver.substr(1));
    outcome.verdict.optimality_gap = outcome.verdict.returned_optimality_gap = 0;
    outcome.steps = {{*outcome.verdict.evaluations_to_solve, 0.1, 0}};
    return std::vector{outcome};
  });
  const auto reported = reported_parts(campaign);
  return held_out_table(rated_parts(campaign, results, reported));
}

TEST(HeldOut, OrderIsThatOfTheOtherHalf) {
  const Table rows = held_out_of(6, 5);
  ASSERT_EQ(rows.rows.size(), 1U);
  EXPECT_EQ(rows[0].text("family"), "bowl");
  EXPECT_EQ(rows[0].number("problems"), 6);
  EXPECT_EQ(rows[0].number("entries"), 5);
  EXPECT_EQ(rows[0].number("correlation"), 1);
  EXPECT_EQ(rows[0].number("first_stays"), 1);
}

TEST(HeldOut, OrderOfFewProblemsOrEntriesIsNotMeasured) {
  for (const Table& rows : {held_out_of(3, 5), held_out_of(6, 4)}) {
    EXPECT_TRUE(is_missing(rows[0]["correlation"]));
  }
}

constexpr int sampled_bowls = 20;
constexpr int made_up_solvers = 6;

/// A family of bowls of which the k-th is solved by the solvers from number k / 4 on, the best of
/// which are the fastest.
std::vector<SampledFamily> samples_of(double share) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {}}};
  for (int k = 0; k < sampled_bowls; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  catalogue.solvers.clear();
  for (int s = 0; s < made_up_solvers; ++s)
    catalogue.solvers.push_back(chance("s" + std::to_string(s)));
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 2\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const int k = std::stoi(cell.cell.problem.substr(5));
    const int s = std::stoi(cell.cell.solver.substr(1));
    Outcome outcome;
    outcome.evaluations = 100 - s;
    outcome.verdict.returned_solved = s >= k / 4;
    outcome.verdict.returned_optimality_gap = outcome.verdict.returned_solved ? 0 : 1;
    outcome.steps = {{outcome.evaluations, 0, *outcome.verdict.returned_optimality_gap}};
    return std::vector{outcome, outcome};
  });
  return sampled_families(campaign, results, share, 3);
}

TEST(Sample, CoversEveryDifficulty) {
  const auto rows = samples_of(0.25);
  ASSERT_EQ(rows.size(), 1U);
  const auto& drawn = rows[0].problems;
  ASSERT_EQ(drawn.size(), 5U);
  EXPECT_EQ(rows[0].of, sampled_bowls);
  // Difficulties are 0, 1/6, ..., 4/6, each of four problems: a stratum each.
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(drawn[static_cast<std::size_t>(k)].second, k / 6.0, 1e-12);
  }
  EXPECT_EQ(rows[0].leader, "s5, original");
  EXPECT_EQ(rows[0].sample_leader, "s5, original");
  EXPECT_NEAR(*rows[0].returned, 1, 1e-12);
  EXPECT_EQ(rows[0].best, 1.0);
  EXPECT_NEAR(rows[0].agreement->correlation, 1, 1e-12);
}

TEST(Sample, HasAtLeastSoManyProblems) {
  EXPECT_EQ(samples_of(0.01)[0].problems.size(), 3U);
  EXPECT_EQ(samples_of(1)[0].problems.size(), static_cast<std::size_t>(sampled_bowls));
}

/// The leaders of a comparison: family, solver, P(best), success rate and whether the budget is the
/// largest.
Table made_up_leaders() {
  return {"leaders", {{"family"}, {"solver"}, {"best"}, {"returned"}, {"takes"}, {"largest"}}};
}

TEST(Opening, SaysWhichSolverHowSureAndOnHowManyProblems) {
  Table leaders = made_up_leaders();
  const std::optional<double> none;
  leaders.add("top-speed", "bisection", 1, 1, 12, true);
  leaders.add("top-speed", "walk", 1, 1, 12, false);
  leaders.add("robust-mean", "bisection", 0.9, 0.92, 12, true);
  leaders.add("hs", "ipopt", 0.89, 0.934, 12, true);
  leaders.add("count", std::nullopt, none, none, none, true);
  leaders.add("hs-many", "slsqp", none, 0.5, 12, true);
  leaders.add("classic", "crs", 0.4, 0.5, 12, true);
  leaders.add("wear", "ipopt", 1, 0.02, 12, true);
  EXPECT_EQ(
      opening_of(leaders),
      "First by mean rank, with a probability P(best) of 0.9 or more on problems like these: "
      "bisection on top-speed, robust-mean (success rate 92 to 100 %, 24 problems). Less sure, "
      "P(best) of 0.5 to 0.9: ipopt on hs (success rate 93 %, 12 problems). On 4 of 7 kinds of "
      "problems no entry is named so: too few solve them, several are as good, or random "
      "search is enough.");
  EXPECT_EQ(opening_of(made_up_leaders()), "");
}

}  // namespace
}  // namespace ricochet::studies::comparison
