#include "src/analysis/comparison/order.h"

#include "src/analysis/comparison/family.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/test.h"

namespace ricochet::studies::comparison {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::SizeIs;

const std::string two_instances = part_of("\"*\"", "solvers = \"*\"\nbudgets = 100\ninstances = 2");

/// The solvers "s0", "s1" and so on.
std::vector<std::string> solvers(int number) {
  std::vector<std::string> names;
  for (int s = 0; s < number; ++s) names.push_back("s" + std::to_string(s));
  return names;
}

int number_of(const PlannedCell& cell) {
  return std::stoi(cell.cell.solver.substr(1));
}

/// Seven solvers on two bowls, which they solve after so many evaluations.
struct TwoBowls : MadeUp {
  explicit TwoBowls(const std::function<int(int solver)>& evaluations)
      : MadeUp(
            two_instances,
            [&](const PlannedCell& cell) {
              const int after = evaluations(number_of(cell));
              return twice(after < 100 ? run_of(after) : run_of({}));
            },
            bowls_and(2, solvers(7))) {}
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

TEST(Beaten, BestValuesAreThoseBelowWhichARunEndsByMoreThanTheTolerance) {
  const double tolerance = bowl("bowl-1", 1).tolerance;
  // The runs of "bowl-1" end with these optimality gaps, those of "bowl-2" with 0.
  const auto beaten_by = [](const std::vector<std::optional<double>>& gaps) {
    const MadeUp made(
        two_instances,
        [&](const PlannedCell& cell) {
          std::vector<Outcome> outcomes(gaps.size());
          for (std::size_t k = 0; k < gaps.size(); ++k) {
            outcomes[k].verdict.optimality_gap = cell.cell.problem == "bowl-1" ? gaps[k] : 0;
          }
          return outcomes;
        },
        bowls_and(2, {"guess"}));
    return rows_of(beaten_table(made.campaign, made.results), "problem,runs,gap,entry");
  };
  EXPECT_THAT(beaten_by({0.5, -1.5 * tolerance, std::nullopt, -3 * tolerance}),
              ElementsAre(fmt::format("bowl-1 | 2 | {} | guess, original", -3 * tolerance)));
  EXPECT_THAT(beaten_by({0, -0.9 * tolerance, std::nullopt}), ElementsAre());
}

TEST(Lacking, AreTheMissingSolversThatThePlanSelects) {
  const auto lacking_of = [](const std::string& selected) {
    std::vector<std::string> names;
    const Plan plan = plan_from(part_of("\"*\"", "solvers = [" + selected + "]"), "test");
    for (const MissingSolver& one :
         lacking(plan, {{"dlib-global-search", "dlib", {}}, {"tao-brgn", "TAO", {}}})) {
      names.push_back(one.solver);
    }
    return names;
  };
  EXPECT_THAT(lacking_of("\"*\""), ElementsAre("dlib-global-search", "tao-brgn"));
  EXPECT_THAT(lacking_of("\"mads\", \"tao-*\""), ElementsAre("tao-brgn"));
  EXPECT_THAT(lacking_of("\"mads\""), ElementsAre());
}

TEST(Summary, CountsOrdersInWhichTheFirstStays) {
  const std::optional<double> none;
  Table orders{"orders", columns_named("family,changed,correlation,same")};
  orders.add("a", "seeds", 0.5, true);
  orders.add("b", "seeds", 0.1, false);
  orders.add("c", "seeds", 0.9, true);
  orders.add("c", "price", none, true);
  EXPECT_THAT(
      rows_of(summary_of(orders, "summary", {"changed"}), "changed,compared,stays,median,least"),
      ElementsAre("seeds | 3 | 2 | 0.5 | 0.1"))
      << "the price is compared with nothing";
}

TEST(HeldOut, OrderIsThatOfTheOtherHalf) {
  // The k-th solver solves every bowl after k evaluations.
  const auto held_out_of = [](int problems, int number) {
    const MadeUp made(
        part_of("\"*\"", "solvers = \"*\"\nbudgets = 100\ninstances = 1"),
        [](const PlannedCell& cell) { return std::vector{run_of(1 + number_of(cell))}; },
        bowls_and(problems, solvers(number)));
    return rows_of(held_out_table(made.rated()), "family,problems,entries,correlation,first_stays");
  };
  EXPECT_THAT(held_out_of(6, 5), ElementsAre("bowl | 6 | 5 | 1 | 1"));
  EXPECT_THAT(held_out_of(3, 5), ElementsAre(testing::StartsWith("bowl | 3 | 5 | - | ")))
      << "too few problems";
  EXPECT_THAT(held_out_of(6, 4), ElementsAre(testing::StartsWith("bowl | 6 | 4 | - | ")))
      << "too few entries";
}

/// Of 20 bowls the k-th is solved by the solvers from number (k - 1) / 4 on, of six, the last of
/// which are the fastest.
std::vector<SampledFamily> samples_of(double share) {
  const MadeUp made(
      two_instances,
      [](const PlannedCell& cell) {
        const int k = std::stoi(cell.cell.problem.substr(5)) - 1;
        const int s = number_of(cell);
        Outcome outcome;
        outcome.evaluations = 100 - s;
        outcome.verdict.returned_solved = s >= k / 4;
        outcome.verdict.returned_optimality_gap = outcome.verdict.returned_solved ? 0 : 1;
        outcome.steps = {{outcome.evaluations, 0, *outcome.verdict.returned_optimality_gap}};
        return twice(outcome);
      },
      bowls_and(20, solvers(6)));
  return sampled_families(made.campaign, made.results, share, 3);
}

TEST(Sample, CoversEveryDifficulty) {
  const auto rows = samples_of(0.25);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].of, 20);
  // Difficulties are 0, 1/6, ..., 4/6, each of four problems: a stratum each.
  std::vector<testing::Matcher<double>> difficulties;
  for (int k = 0; k < 5; ++k) difficulties.push_back(DoubleNear(k / 6.0, 1e-12));
  std::vector<double> drawn;
  for (const auto& problem : rows[0].problems) drawn.push_back(problem.second);
  EXPECT_THAT(drawn, testing::ElementsAreArray(difficulties));
  EXPECT_EQ(rows[0].leader, "s5, original");
  EXPECT_EQ(rows[0].sample_leader, "s5, original");
  EXPECT_NEAR(*rows[0].returned, 1, 1e-12);
  EXPECT_EQ(rows[0].best, 1.0);
  EXPECT_NEAR(rows[0].agreement->correlation, 1, 1e-12);
}

TEST(Sample, HasAtLeastSoManyProblems) {
  EXPECT_THAT(samples_of(0.01)[0].problems, SizeIs(3));
  EXPECT_THAT(samples_of(1)[0].problems, SizeIs(20));
}

TEST(Opening, SaysWhichSolverHowSureAndOnHowManyProblems) {
  Table leaders{"leaders", columns_named("family,solver,best,returned,takes,largest")};
  EXPECT_EQ(opening_of(leaders), "");
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
}

}  // namespace
}  // namespace ricochet::studies::comparison
