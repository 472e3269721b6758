#include <gmock/gmock.h>

#include "problems/classic/classic.h"
#include "src/analysis/comparison/study.h"
#include "src/experiment/planned_runs.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies {
namespace {

using report::Json;
using testing::HasSubstr;

/// Evaluates points on the way from the start to the best point, and returns the last one. Then it
/// evaluates a point where problems fail, or nothing more.
Solver walker(const std::string& name, bool beyond) {
  Solver solver = chance(name);
  solver.solve = [beyond](Evaluator& evaluator, const Vector& /*start*/, Random&) {
    const Vector best = Vector::Constant(2, 0.3);
    evaluator.objective(best);
    if (beyond) evaluator.objective(Vector::Constant(2, 0.1));
    return SolverTermination{"there", best};
  };
  return solver;
}

class PathologicalRuns : public TemporaryFolder {
 protected:
  /// The data of a comparison on the problems as they are stated, with a bowl where wanted.
  Json data_of(const std::string& problems) const {
    Catalogue catalogue = made_up_catalogue();
    catalogue.own_solver = nullptr;
    catalogue.families.push_back(classic::pathological_family());
    for (Problem& problem : catalogue.families.back().problems) {
      if (problem.longest_run) problem.longest_run = 0.3;
    }
    catalogue.solvers = {walker("careful", false), walker("careless", true)};
    Plan plan = plan_from(
        "[[part]]\nproblems = " + problems + "\nsolvers = \"*\"\nbudgets = [10]\ninstances = 1\n",
        "test");
    plan.first_instance = 0;
    const Campaign campaign(plan, catalogue);
    std::filesystem::remove(folder_ / "runs.sqlite");  // of an earlier call
    Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
    make_runs(campaign, {}, store);
    return comparison_study(campaign, store).compute(false);
  }

  static Json page_of(const Json& data, const std::string& folder) {
    for (const Json& page : data.at("pages")) {
      if (page.at("folder") == folder) return page.at("data");
    }
    return {};
  }
};

TEST_F(PathologicalRuns, AreCountedByTheirEndings) {
  const Json page = page_of(data_of("\"pathological-*\""), "robustness");
  const report::Results results = report::results_in(page);
  const Table& solvers = *results.table("pathological-solvers");
  const Row careful = solvers[0], careless = solvers[1];
  EXPECT_EQ(careful.text("solver"), "careful");
  for (const char* name : {"throws", "hangs", "crashes"}) {
    EXPECT_EQ(careful.text("pathological-" + std::string(name)), "1 solved") << name;
  }
  EXPECT_EQ(careless.text("pathological-throws"), "1 threw");
  EXPECT_EQ(careless.text("pathological-hangs"), "1 killed");
  EXPECT_EQ(careless.text("pathological-crashes"), "1 crashed");
  EXPECT_EQ(careless.text("pathological-no-number"), "1 solved");
  const Table& problems = *results.table("pathological");
  const auto throws =
      problems.find([](const Row& row) { return row.text("problem") == "pathological-throws"; });
  EXPECT_EQ(throws->number("runs"), 2);
  EXPECT_EQ(throws->number("solved"), 1);
  EXPECT_EQ(throws->number("threw"), 1);
  EXPECT_EQ(throws->number("found"), 2) << "both evaluated the best point";
  const std::string text =
      filled_page(report::page_source(report::page_template("comparison_failures")), results);
  EXPECT_THAT(text, HasSubstr("1 killed"));
  EXPECT_THAT(text, testing::Not(HasSubstr("perturbation")));
}

TEST_F(PathologicalRuns, HaveNoShareInRankings) {
  const Json data = data_of("[\"bowl-2\", \"pathological-throws\", \"pathological-plateau\"]");
  EXPECT_EQ(report::results_in(data).table("leaders")->rows.size(), 1U);
  EXPECT_TRUE(page_of(data, "pathological").is_null());
  EXPECT_THAT(page_of(data, "view").dump(), testing::Not(HasSubstr("pathological")));
  const report::Results page = report::results_in(page_of(data, "robustness"));
  EXPECT_EQ(page.table("pathological")->rows.size(), 2U);
  EXPECT_TRUE(page_of(data_of("\"bowl-2\""), "robustness").is_null());
}

}  // namespace
}  // namespace ricochet::studies
