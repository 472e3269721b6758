#include "src/analysis/comparison/study.h"

#include "problems/classic/classic.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ComparisonStudy : public TemporaryFolder {
 protected:
  /// The data of the study of a plan, whose runs are made.
  Json data_of(Plan plan, Catalogue catalogue = made_up_catalogue()) const {
    catalogue.own_solver = nullptr;
    const Campaign campaign = searched_campaign(plan, catalogue);
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

  /// The filled page of a kind of report.
  static std::string filled(const Json& data) {
    Json made = data;
    made["made"] = {{"version", "1"},
                    {"compiler", "GCC"},
                    {"threads", 2},
                    {"seconds", 1},
                    {"date", "2026-01-01"}};
    const auto page = report::page_source(report::page_template(data.at("report")));
    return filled_page(page, report::results_of(made));
  }
};

TEST_F(ComparisonStudy, FillsEveryPageWithWhatItsNamesAskFor) {
  Json data = data_of(plan_from(part_of(R"(["bowl-1", "bowl-2", "cup-s"])",
                                        "solvers = \"*\"\nbudgets = [10, 100]\ninstances = 2\n"
                                        "perturbations = [\"plain\", \"noisy\"]"),
                                "test"));
  data["report"] = "comparison";
  std::set<std::string> folders;
  EXPECT_THAT(filled(data), HasSubstr("| bowl | 100 |"));
  for (const Json& page : data.at("pages")) {
    folders.insert(page.at("folder").get<std::string>());
    EXPECT_THAT(filled(page.at("data")), testing::StartsWith("# ")) << page.at("folder");
  }
  EXPECT_EQ(folders, (std::set<std::string>{"bowl", "cup", "robustness", "solvers", "view"}));
}

TEST_F(ComparisonStudy, HasAMapOfWhoSolvesWhat) {
  const report::Results results = report::results_in(data_of(plan_from(
      part_of(R"(["bowl-1", "cup-s"])", "solvers = \"*\"\nbudgets = [100]\ninstances = 2"),
      "test")));
  const Table& map = *results.table("map");
  ASSERT_EQ(map.rows.size(), 3U);
  EXPECT_TRUE(map.has("cup"));
  each_row(map, [&](const Row& row) {
    const Table own = where(*results.table("speed-accuracy"), [&](const Row& other) {
      return other["solver"] == row["solver"] && other.text("family") == "bowl";
    });
    EXPECT_EQ(row["bowl"], own[0]["share"]);
  });
}

/// Evaluates the best point and returns it. In between it evaluates a point where problems fail, or
/// nothing more.
Solver finder(const std::string& name, bool beyond) {
  Solver solver = chance(name);
  solver.solve = [beyond](Evaluator& evaluator, const Vector& /*start*/, Random&) {
    const Vector best = Vector::Constant(2, 0.3);
    evaluator.objective(best);
    if (beyond) evaluator.objective(Vector::Constant(2, 0.1));
    return SolverTermination{"there", best};
  };
  return solver;
}

class PathologicalRuns : public ComparisonStudy {
 protected:
  /// The data of a comparison on the problems as they are stated, with a bowl where wanted.
  Json data_on(const std::string& problems) const {
    Catalogue catalogue = made_up_catalogue();
    catalogue.families.push_back(classic::pathological_family());
    for (Problem& problem : catalogue.families.back().problems) {
      if (problem.longest_run) problem.longest_run = 0.3;
    }
    catalogue.solvers = {finder("careful", false), finder("careless", true)};
    Plan plan =
        plan_from(part_of(problems, "solvers = \"*\"\nbudgets = [10]\ninstances = 1"), "test");
    plan.first_instance = 0;
    return data_of(plan, catalogue);
  }
};

TEST_F(PathologicalRuns, AreCountedByTheirEndings) {
  const report::Results results =
      report::results_in(page_of(data_on("\"pathological-*\""), "robustness"));
  EXPECT_THAT(rows_of(*results.table("pathological-solvers"),
                      "solver,pathological-throws,pathological-hangs,pathological-crashes,"
                      "pathological-no-number"),
              ElementsAre(testing::StartsWith("careful | 1 solved | 1 solved | 1 solved | "),
                          "careless | 1 threw | 1 killed | 1 crashed | 1 solved"));
  // Both evaluated the best point.
  EXPECT_THAT(rows_of(*results.table("pathological"), "problem,runs,solved,threw,found"),
              testing::Contains("pathological-throws | 2 | 1 | 1 | 2"));
  EXPECT_THAT(
      filled_page(report::page_source(report::page_template("comparison_failures")), results),
      AllOf(HasSubstr("1 killed"), Not(HasSubstr("perturbation"))));
}

TEST_F(PathologicalRuns, HaveNoShareInRankings) {
  const Json data = data_on("[\"bowl-2\", \"pathological-throws\", \"pathological-plateau\"]");
  EXPECT_EQ(report::results_in(data).table("leaders")->rows.size(), 1U);
  EXPECT_TRUE(page_of(data, "pathological").is_null());
  EXPECT_THAT(page_of(data, "view").dump(), Not(HasSubstr("pathological")));
  const report::Results page = report::results_in(page_of(data, "robustness"));
  EXPECT_EQ(page.table("pathological")->rows.size(), 2U);
  EXPECT_TRUE(page_of(data_on("\"bowl-2\""), "robustness").is_null());
}

/// Bowls of machines: restitution 0.1 and 0.9, friction 0 and 1; the best value is the product.
Campaign campaign_of_machines() {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [](const MachineGrid&) {
    std::vector<SearchedProblem> problems;
    for (const double restitution : {0.1, 0.9}) {
      for (const double friction : {0.0, 1.0}) {
        const std::string machine = "M" + std::to_string(problems.size());
        Problem problem = bowl("bowl-" + machine, 1);
        problem.machine = machine;
        problem.factors = {
            {"restitution", restitution}, {"friction", friction}, {"disturbance", 0}};
        problem.best_known = restitution * friction;
        problems.push_back(searched(problem, nullptr));
      }
    }
    return problems;
  };
  return searched_campaign(
      plan_from(part_of("\"*\"",
                        "solvers = [\"chance-*\"]\nbudgets = [100]\ninstances = 1\n"
                        "machines = {around = \"C1\", restitution = [0.1, 0.9], "
                        "friction = [0, 1]}"),
                "test"),
      catalogue);
}

using Cells = std::vector<std::optional<double>>;

/// chance-a solves at the high friction only; the others never solve, and throw.
TEST(Machines, HaveMapsOverTheirConstantsAndALandscapeEach) {
  const MadeUp made(campaign_of_machines(), [](const PlannedCell& cell) {
    const bool high = cell.cell.problem == "bowl-M1" || cell.cell.problem == "bowl-M3";
    Outcome outcome = cell.cell.solver == "chance-a" && high ? run_of(100) : run_of({});
    outcome.verdict.feasible = true;
    if (cell.cell.solver != "chance-a") outcome.failure = "threw: no";
    return std::vector{outcome};
  });
  const report::Results page = machines_page(made.rated()).parts.at("families").at(0).results;
  const report::Chart& known = *page.chart("known");
  EXPECT_EQ(known.x.label, "friction");
  EXPECT_THAT(known.x.categories, ElementsAre("0", "1"));
  EXPECT_THAT(known.y.categories, ElementsAre("restitution 0.9", "restitution 0.1"));
  EXPECT_EQ(known.heat_map->rows, (std::vector<Cells>{{0.0, 0.9}, {0.0, 0.1}}));
  EXPECT_EQ(known.title, "bowl: best known values of 0 to 0.9");
  const report::Chart& landscape = *page.chart("landscape");
  const Problem& stated = made.campaign.problems().front();
  EXPECT_EQ(landscape.x.categories.front(), fmt::format("{:.3g}", stated.lower[0]));
  EXPECT_EQ(landscape.x.categories.back(), fmt::format("{:.3g}", stated.upper[0]));
  ASSERT_EQ(landscape.heat_map->rows.size(), 4U);
  EXPECT_EQ(landscape.y.categories[1], "friction 0, restitution 0.9");
  const Cells& row = landscape.heat_map->rows[1];
  ASSERT_EQ(row.size(), landscape.x.categories.size());
  EXPECT_EQ(row.front(), true_values_at(stated, stated.lower).objective);
  EXPECT_EQ(row.back(), true_values_at(stated, stated.upper).objective);
  const auto levels = rows_of(*page.table("levels"), "changed,setting,first,returned,same");
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_THAT(levels[0], testing::StartsWith("friction | 0 | none | "))
      << "at no friction nobody solves";
  EXPECT_EQ(levels[1], "friction | 1 | chance-a, original | 1 | no");
}

TEST(MachinesPage, HasNoFamilyWithoutAGrid) {
  const MadeUp made(part_of("\"bowl-1\"", "solvers = \"*\"\ninstances = 1"),
                    [](const PlannedCell&) { return std::vector{Outcome()}; });
  EXPECT_TRUE(machines_page(made.rated()).parts.empty());
}

}  // namespace
}  // namespace ricochet::studies::comparison
