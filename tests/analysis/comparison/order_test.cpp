#include "src/analysis/comparison/order.h"

#include "src/analysis/comparison/family.h"
#include "tests/analysis/comparison/made_up_results.h"

namespace ricochet::studies::comparison {
namespace {

using testing::SizeIs;

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
using Evaluations = std::function<int(int solver)>;

MadeUp two_bowls(const Evaluations& evaluations) {
  const auto runs_of = [&](const PlannedCell& cell) {
    const int after = evaluations(number_of(cell));
    return twice(after < 100 ? run_of(after) : run_of({}));
  };
  return MadeUp(two_runs("\"*\""), runs_of, bowls_and(2, solvers(7)));
}

/// The leader of the first, its P(best), its place in the second, the leader there, and how far the
/// orders agree.
std::string agreement_in_words(const Evaluations& in_first, const Evaluations& in_second) {
  const MadeUp first = two_bowls(in_first), second = two_bowls(in_second);
  const FamilyAgreement row =
      family_agreements(first.campaign, first.results, second.campaign, second.results).at(0);
  const auto number = [](std::optional<double> x) { return x ? fmt::format("{:.9g}", *x) : "-"; };
  return fmt::format("{}: {}, P {}, is number {} where {} leads; correlation {}", row.family,
                     row.leader, number(row.best), number(row.place), row.other_leader,
                     row.agreement ? number(row.agreement->correlation) : "-");
}

TEST(AgreementOfCampaigns, IsOneForTheSameOrderAndMinusOneForTheOpposite) {
  const auto rising = [](int s) { return 10 + s; };
  EXPECT_EQ(agreement_in_words(rising, [](int s) { return 20 + 2 * s; }),
            "bowl: s0, original, P 1, is number 1 where s0, original leads; correlation 1");
  EXPECT_EQ(agreement_in_words(rising, [](int s) { return 90 - s; }),
            "bowl: s0, original, P 1, is number 7 where s6, original leads; correlation -1");
  EXPECT_EQ(agreement_in_words([](int) { return 100; }, rising),
            "bowl: none, P -, is number - where s0, original leads; correlation -")
      << "nothing is solved, and all are tied";
}

TEST(Beaten, BestValuesAreThoseBelowWhichARunEndsByMoreThanTheTolerance) {
  const double tolerance = bowl("bowl-1", 1).tolerance;
  // The runs of "bowl-1" end with these optimality gaps, those of "bowl-2" with 0.
  const auto beaten_by = [](const std::vector<std::optional<double>>& gaps) {
    const auto runs_of = [&](const PlannedCell& cell) {
      std::vector<Outcome> outcomes(gaps.size());
      for (std::size_t k = 0; k < gaps.size(); ++k) {
        outcomes[k].verdict.optimality_gap = cell.cell.problem == "bowl-1" ? gaps[k] : 0;
      }
      return outcomes;
    };
    const MadeUp made(two_runs("\"*\""), runs_of, bowls_and(2, {"guess"}));
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
    const std::vector<MissingSolver> missing = {{"dlib-global-search", "dlib", {}},
                                                {"tao-brgn", "TAO", {}}};
    for (const MissingSolver& one : lacking(plan, missing)) names.push_back(one.solver);
    return names;
  };
  EXPECT_THAT(lacking_of("\"*\""), ElementsAre("dlib-global-search", "tao-brgn"));
  EXPECT_THAT(lacking_of("\"mads\", \"tao-*\""), ElementsAre("tao-brgn"));
  EXPECT_THAT(lacking_of("\"mads\""), ElementsAre());
}

TEST(Summary, CountsOrdersInWhichTheFirstStays) {
  Table orders{"orders", columns_named("family,changed,correlation,same")};
  orders.add("a", "seeds", 0.5, true);
  orders.add("b", "seeds", 0.1, false);
  orders.add("c", "seeds", 0.9, true);
  orders.add("c", "price", std::nullopt, true);
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
  // Too few problems, too few entries.
  EXPECT_THAT(held_out_of(3, 5), ElementsAre(StartsWith("bowl | 3 | 5 | - | ")));
  EXPECT_THAT(held_out_of(6, 4), ElementsAre(StartsWith("bowl | 6 | 4 | - | ")));
}

/// Of 20 bowls the k-th is solved by the solvers from number (k - 1) / 4 on, of six, the last of
/// which are the fastest.
std::vector<SampledFamily> samples_of(double share) {
  const auto runs_of = [](const PlannedCell& cell) {
    const int k = std::stoi(cell.cell.problem.substr(5)) - 1, s = number_of(cell);
    return twice(s >= k / 4 ? run_of(100 - s) : run_of({}));
  };
  const MadeUp made(two_runs("\"*\""), runs_of, bowls_and(20, solvers(6)));
  return sampled_families(made.campaign, made.results, share, 3);
}

TEST(Sample, CoversEveryDifficulty) {
  const auto rows = samples_of(0.25);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].of, 20);
  // Difficulties are 0, 1/6, ..., 4/6, each of four problems: a stratum each.
  ASSERT_EQ(rows[0].problems.size(), 5U);
  double difficulty = 0;
  for (const auto& [name, own] : rows[0].problems) {
    EXPECT_NEAR(own, difficulty, 1e-12) << name;
    difficulty += 1.0 / 6;
  }
  EXPECT_EQ(rows[0].leader, "s5, original");
  EXPECT_EQ(rows[0].sample_leader, "s5, original");
  EXPECT_NEAR(*rows[0].returned, 1, 1e-12);
  EXPECT_EQ(rows[0].best, 1.0);
  EXPECT_NEAR(rows[0].agreement->correlation, 1, 1e-12);
  EXPECT_THAT(samples_of(1)[0].problems, SizeIs(20));
  EXPECT_THAT(samples_of(0.01)[0].problems, SizeIs(3)) << "at least";
}

TEST(Opening, SaysWhichSolverHowSureAndOnHowManyProblems) {
  Table leaders{"leaders", columns_named("family,solver,best,returned,takes,largest")};
  EXPECT_EQ(opening_of(leaders), "");
  leaders.add("top-speed", "bisection", 1, 1, 12, true);
  leaders.add("top-speed", "walk", 1, 1, 12, false);
  leaders.add("robust-mean", "bisection", 0.9, 0.92, 12, true);
  leaders.add("hs", "ipopt", 0.89, 0.934, 12, true);
  leaders.add("count", std::nullopt, std::nullopt, std::nullopt, std::nullopt, true);
  leaders.add("hs-many", "slsqp", std::nullopt, 0.5, 12, true);
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
