#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "src/analysis/comparison/pairs.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A campaign of seven solvers on two bowls, which they solve after so many evaluations.
struct MadeUp {
  explicit MadeUp(const std::function<int(int solver)>& evaluations)
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

Json row_of(const MadeUp& first, const MadeUp& second) {
  return agreement_data(first.campaign, first.results, second.campaign, second.results).at(0);
}

TEST(AgreementOfCampaigns, IsOneForTheSameOrderAndMinusOneForTheOpposite) {
  const MadeUp rising([](int s) { return 10 + s; });
  const Json same = row_of(rising, MadeUp([](int s) { return 20 + 2 * s; }));
  EXPECT_EQ(same["family"], "bowl");
  EXPECT_NEAR(same["agreement"]["correlation"].get<double>(), 1, 1e-12);
  EXPECT_EQ(same["leader"], "s0, original");
  EXPECT_EQ(same["place"], 1);
  EXPECT_EQ(same["best"], 1.0);
  const Json opposite = row_of(rising, MadeUp([](int s) { return 90 - s; }));
  EXPECT_NEAR(opposite["agreement"]["correlation"].get<double>(), -1, 1e-12);
  EXPECT_EQ(opposite["place"], 7);
  EXPECT_EQ(opposite["other_leader"], "s6, original");
}

TEST(AgreementOfCampaigns, HasNoLeaderWhereNothingIsSolved) {
  const Json row = row_of(MadeUp([](int) { return 100; }), MadeUp([](int s) { return 10 + s; }));
  EXPECT_EQ(row["leader"], "none");
  EXPECT_TRUE(row["best"].is_null());
  EXPECT_TRUE(row["place"].is_null());
  EXPECT_TRUE(row["agreement"].is_null()) << "all are tied";
}

}  // namespace
}  // namespace ricochet::studies::comparison
