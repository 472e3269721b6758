#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "tests/core/best_point_of.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

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
  Table changes_of(const std::string& plan, const Catalogue& catalogue) const {
    const Campaign campaign = searched_campaign(plan_from(plan, "test"), catalogue);
    Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
    make_runs(campaign, {}, store);
    const std::vector<CellResult> results = cell_results(campaign, store);
    const std::vector<ReportedPart> reported = reported_parts(campaign);
    const std::vector<RatedPart> parts = rated_parts(campaign, results, reported);
    const Table changes = change_table(campaign, results, parts);
    return changes.rows.empty() ? level_table(parts[0].comparison, parts[0].groups[0]) : changes;
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
  const Table rows = changes_of(
      "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "machines = {around = \"C1\", fidelity = [\"impact\", \"compliant\", \"planar\"]}",
      catalogue);
  ASSERT_EQ(rows.rows.size(), 3U) << "the restitution is the same everywhere";
  each_row(rows, [](const Row& row) {
    EXPECT_EQ(row.text("changed"), "fidelity");
    EXPECT_EQ(row.text("family"), "bowl");
    EXPECT_EQ(row.number("entries"), 6);
  });
  EXPECT_EQ(rows[0].text("setting"), "impact");
  EXPECT_EQ(rows[0].text("first"), "walker-1, original");
  EXPECT_TRUE(is_missing(rows[0]["correlation"]));
  EXPECT_EQ(rows[1].text("setting"), "compliant");
  EXPECT_EQ(rows[1].number("correlation"), 1);
  EXPECT_EQ(rows[1].is("same"), true);
  EXPECT_EQ(rows[2].text("setting"), "planar");
  EXPECT_EQ(rows[2].number("correlation"), -1);
  EXPECT_EQ(rows[2].text("first"), "walker-6, original");
  EXPECT_EQ(rows[2].is("same"), false);
  EXPECT_TRUE(is_missing(rows[2]["best"])) << "one problem a level";
  EXPECT_EQ(rows[2].number("problems"), 1);
}

TEST_F(Changes, OfSmoothingAndPriceAreComparedWithTheUsualOnes) {
  const Table rows = changes_of(
      "[[part]]\nproblems = \"cup-s\"\nsolvers = \"*\"\nbudgets = 20\ninstances = 2\n"
      "smoothings = [0.125, 1]\nformulations = \"surrogate*\"\ngradient_prices = [0, \"n\"]",
      catalogue_of([](const std::string&) { return true; }));
  std::vector<std::string> said;
  each_row(rows, [&](const Row& row) {
    said.push_back(row.text("changed") + " " + row.text("setting"));
    EXPECT_TRUE(row.is("same")) << said.back();
  });
  EXPECT_EQ(said,
            (std::vector<std::string>{
                "price of a gradient n", "price of a gradient 0", "smoothing of the surrogate 0.5",
                "smoothing of the surrogate 0.125", "smoothing of the surrogate 1"}));
  EXPECT_EQ(rows[3].number("entries"), 6) << "those that are shown this smoothing alone";
  EXPECT_EQ(rows[3].text("first"), "walker-1");
  EXPECT_EQ(rows[3].number("correlation"), 1);
}

TEST(LevelName, IsThatOfTheFidelity) {
  EXPECT_EQ(level_name("fidelity", 1), "compliant");
  EXPECT_EQ(level_name("restitution", 0.5), "0.5");
}

}  // namespace
}  // namespace ricochet::studies::comparison
