#include "src/studies/contest/change_data.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/campaign/planned_runs.h"
#include "src/studies/contest/machine_results.h"
#include "tests/campaign/made_up_catalogue.h"
#include "tests/core/temporary_folder.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// Stays at a point, the further from the best one the higher its number, or, where it does not
/// rise, the lower.
Solver walker(int number, bool (*rises)(const Problem&)) {
  Solver solver = chance("walker-" + std::to_string(number));
  solver.accepts = [](const Problem&) { return true; };
  solver.solve = [number, rises](Evaluator& evaluator, const Vector&, Random&) {
    const int rank = rises(evaluator.problem()) ? number : 9 - number;
    const Vector x = evaluator.problem().best_point->array() + 0.01 * rank;
    while (evaluator.objective(x)) {
    }
    return SolverExit{"spent"};
  };
  return solver;
}

class Changes : public TemporaryFolder {
 protected:
  /// What the report says of the runs of this plan.
  Json data_of(const std::string& plan, const Catalogue& catalogue) const {
    const Campaign campaign(plan_from(plan, "test"), catalogue);
    Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
    make_runs(campaign, {}, store);
    return change_data(campaign, stored_standings(campaign, store), reported_parts(campaign));
  }
};

/// Six walkers, in the order of their numbers but where they turn.
Catalogue catalogue_of(bool (*rises)(const Problem&)) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.own_solver = nullptr;
  catalogue.solvers.clear();
  for (int k = 1; k <= 6; ++k) catalogue.solvers.push_back(walker(k, rises));
  return catalogue;
}

TEST_F(Changes, OfTheFidelityTurnTheOrderOver) {
  Catalogue catalogue =
      catalogue_of([](const Problem& problem) { return !problem.name.ends_with("planar"); });
  catalogue.families_of = [](const MachineGrid& grid) {
    Family family{"bowl", {}};
    for (std::size_t k = 0; k < grid.fidelity.size(); ++k) {
      Question question = bowl("bowl-" + grid.fidelity[k], 1);
      question.machine = grid.fidelity[k];
      question.factors = {{"fidelity", static_cast<double>(k)}, {"restitution", 0.5}};
      family.questions.push_back(question);
    }
    return std::vector{family};
  };
  const Json rows = data_of(
      "[[part]]\nquestions = \"*\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "machines = {around = \"C1\", fidelity = [\"impact\", \"compliant\", \"planar\"]}",
      catalogue);
  ASSERT_EQ(rows.size(), 3U) << "the restitution is the same everywhere\n" << rows;
  for (const Json& row : rows) {
    EXPECT_EQ(row["changed"], "fidelity");
    EXPECT_EQ(row["family"], "bowl");
    EXPECT_EQ(row["competitors"], 6);
  }
  EXPECT_EQ(rows[0]["setting"], "impact");
  EXPECT_EQ(rows[0]["leader"], "walker-1, as-stated");
  EXPECT_TRUE(rows[0]["agreement"].is_null());
  EXPECT_EQ(rows[1]["setting"], "compliant");
  EXPECT_EQ(rows[1]["agreement"]["correlation"], 1);
  EXPECT_EQ(rows[1]["same_leader"], true);
  EXPECT_EQ(rows[2]["setting"], "planar");
  EXPECT_EQ(rows[2]["agreement"]["correlation"], -1);
  EXPECT_EQ(rows[2]["leader"], "walker-6, as-stated");
  EXPECT_EQ(rows[2]["same_leader"], false);
  EXPECT_GT(rows[2]["best"], 0.3);
}

TEST_F(Changes, OfWidthAndPriceAreComparedWithTheUsualOnes) {
  const Json rows = data_of(
      "[[part]]\nquestions = \"cup-s\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "widths = [0.125, 1]\nforms = \"surrogate*\"\ngradient_prices = [0, \"n\"]",
      catalogue_of([](const Problem&) { return true; }));
  std::vector<std::string> said;
  for (const Json& row : rows) {
    said.push_back(row["changed"].get<std::string>() + " " + row["setting"].get<std::string>());
    EXPECT_EQ(row["same_leader"], true) << row;
  }
  EXPECT_EQ(said,
            (std::vector<std::string>{"price of a gradient n", "price of a gradient 0",
                                      "width of the surrogate 0.5", "width of the surrogate 0.125",
                                      "width of the surrogate 1"}));
  EXPECT_EQ(rows[3]["competitors"], 6) << "those that are shown this width alone";
  EXPECT_EQ(rows[3]["leader"], "walker-1");
  EXPECT_EQ(rows[3]["agreement"]["correlation"], 1);
}

TEST(LevelName, IsThatOfTheFidelity) {
  EXPECT_EQ(level_name("fidelity", 1), "compliant");
  EXPECT_EQ(level_name("restitution", 0.5), "0.5");
}

}  // namespace
}  // namespace ricochet::studies::contest
