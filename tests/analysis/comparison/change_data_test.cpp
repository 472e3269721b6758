#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/analysis/comparison/sections.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "tests/core/best_point_of.h"
#include "tests/core/temporary_folder.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Stays at a point, the further from the best one the higher its number, or, where it does not
/// rise, the lower; the nearest of six solves the problem.
Solver walker(int number, bool (*rises)(const std::string& problem)) {
  Solver solver = chance("walker-" + std::to_string(number));
  solver.solve = [number, rises](Evaluator& evaluator, const Vector&, Random&) {
    const int rank = rises(evaluator.name()) ? number - 1 : 6 - number;
    const Problem known = bowl(evaluator.name(), evaluator.dimension());
    const Vector x = best_point_of(known, evaluator).array() + 0.01 * rank;
    while (evaluator.objective(x)) {
    }
    return SolverTermination{"spent", x};
  };
  return solver;
}

class Changes : public TemporaryFolder {
 protected:
  /// What the report says of the runs of this plan.
  Json data_of(const std::string& plan, const Catalogue& catalogue) const {
    const Campaign campaign = searched_campaign(plan_from(plan, "test"), catalogue);
    Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
    make_runs(campaign, {}, store);
    return change_data(campaign, cell_results(campaign, store), reported_parts(campaign));
  }
};

/// Six walkers, in the order of their numbers but where they turn.
Catalogue catalogue_of(bool (*rises)(const std::string& problem)) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.own_solver = nullptr;
  catalogue.solvers.clear();
  for (int k = 1; k <= 6; ++k) catalogue.solvers.push_back(walker(k, rises));
  return catalogue;
}

TEST_F(Changes, OfTheFidelityTurnTheOrderOver) {
  Catalogue catalogue =
      catalogue_of([](const std::string& problem) { return !problem.ends_with("planar"); });
  catalogue.grid_problems = [](const MachineGrid& grid) {
    std::vector<SearchedProblem> problems;
    const std::vector<OptionValue>& levels = grid.levels.at("fidelity");
    for (std::size_t k = 0; k < levels.size(); ++k) {
      Problem problem = bowl("bowl-" + std::get<std::string>(levels[k]), 1);
      problem.machine = std::get<std::string>(levels[k]);
      problem.factors = {{"fidelity", static_cast<double>(k)}, {"restitution", 0.5}};
      problems.push_back(searched(problem, nullptr));
    }
    return problems;
  };
  const Json rows = data_of(
      "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "machines = {around = \"C1\", fidelity = [\"impact\", \"compliant\", \"planar\"]}",
      catalogue);
  ASSERT_EQ(rows.size(), 3U) << "the restitution is the same everywhere\n" << rows;
  for (const Json& row : rows) {
    EXPECT_EQ(row["changed"], "fidelity");
    EXPECT_EQ(row["family"], "bowl");
    EXPECT_EQ(row["entries"], 6);
  }
  EXPECT_EQ(rows[0]["setting"], "impact");
  EXPECT_EQ(rows[0]["leader"], "walker-1, original");
  EXPECT_TRUE(rows[0]["agreement"].is_null());
  EXPECT_EQ(rows[1]["setting"], "compliant");
  EXPECT_EQ(rows[1]["agreement"]["correlation"], 1);
  EXPECT_EQ(rows[1]["same_leader"], true);
  EXPECT_EQ(rows[2]["setting"], "planar");
  EXPECT_EQ(rows[2]["agreement"]["correlation"], -1);
  EXPECT_EQ(rows[2]["leader"], "walker-6, original");
  EXPECT_EQ(rows[2]["same_leader"], false);
  EXPECT_TRUE(rows[2]["best"].is_null()) << "one problem a level";
  EXPECT_EQ(rows[2]["problems"], 1);
  EXPECT_EQ(rows[2]["agreement"]["solvers"], 6);
}

TEST_F(Changes, OfSmoothingAndPriceAreComparedWithTheUsualOnes) {
  const Json rows = data_of(
      "[[part]]\nproblems = \"cup-s\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "smoothings = [0.125, 1]\nformulations = \"surrogate*\"\ngradient_prices = [0, \"n\"]",
      catalogue_of([](const std::string&) { return true; }));
  std::vector<std::string> said;
  for (const Json& row : rows) {
    said.push_back(row["changed"].get<std::string>() + " " + row["setting"].get<std::string>());
    EXPECT_EQ(row["same_leader"], true) << row;
  }
  EXPECT_EQ(said,
            (std::vector<std::string>{
                "price of a gradient n", "price of a gradient 0", "smoothing of the surrogate 0.5",
                "smoothing of the surrogate 0.125", "smoothing of the surrogate 1"}));
  EXPECT_EQ(rows[3]["entries"], 6) << "those that are shown this smoothing alone";
  EXPECT_EQ(rows[3]["leader"], "walker-1");
  EXPECT_EQ(rows[3]["agreement"]["correlation"], 1);
}

TEST(LevelName, IsThatOfTheFidelity) {
  EXPECT_EQ(level_name("fidelity", 1), "compliant");
  EXPECT_EQ(level_name("restitution", 0.5), "0.5");
}

}  // namespace
}  // namespace ricochet::studies::comparison
