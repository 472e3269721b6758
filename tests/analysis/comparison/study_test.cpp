#include "src/analysis/comparison/study.h"

#include "problems/classic/classic.h"
#include "ricochet/solver.h"
#include "src/analysis/comparison/leaders.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/files.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

class ComparisonStudy : public TemporaryFolder {
 protected:
  /// The data of the study of a plan, whose runs are made.
  Json data_of(const std::string& text, Catalogue catalogue = made_up_catalogue(),
               int first_instance = 1) const {
    catalogue.own_solver = nullptr;
    Plan plan = plan_from(text, "test");
    plan.first_instance = first_instance;
    const Campaign campaign = searched_campaign(plan, catalogue);
    fs::remove(folder_ / "runs.sqlite");  // of an earlier call
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
    for (const char* what : {"version", "compiler", "threads", "seconds", "date"}) {
      made["made"][what] = 2;
    }
    const auto page = report::page_source(report::page_template(data.at("report")));
    return filled_page(page, report::results_of(made));
  }
};

TEST_F(ComparisonStudy, FillsEveryPageWithWhatItsNamesAskFor) {
  Json data = data_of(part_of(R"(["bowl-1", "bowl-2", "cup-s"])",
                              "solvers = \"*\"\nbudgets = [10, 100]\ninstances = 2\n"
                              "perturbations = [\"plain\", \"noisy\"]"));
  data["report"] = "comparison";
  std::set<std::string> folders;
  EXPECT_THAT(filled(data), HasSubstr("| bowl | 100 |"));
  for (const Json& page : data.at("pages")) {
    folders.insert(page.at("folder").get<std::string>());
    EXPECT_THAT(filled(page.at("data")), StartsWith("# ")) << page.at("folder");
  }
  EXPECT_THAT(folders, ElementsAre("bowl", "cup", "robustness", "solvers", "view"));
  const report::Results results = report::results_in(data);
  const Table& map = *results.table("map");  // of who solves what
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
    return data_of(part_of(problems, "solvers = \"*\"\nbudgets = [10]\ninstances = 1"), catalogue,
                   0);
  }
};

TEST_F(PathologicalRuns, AreCountedByTheirEndings) {
  const report::Results results =
      report::results_in(page_of(data_on("\"pathological-*\""), "robustness"));
  EXPECT_THAT(rows_of(*results.table("pathological-solvers"),
                      "solver,pathological-throws,pathological-hangs,pathological-crashes,"
                      "pathological-no-number"),
              ElementsAre(StartsWith("careful | 1 solved | 1 solved | 1 solved | "),
                          "careless | 1 threw | 1 killed | 1 crashed | 1 solved"));
  // Both evaluated the best point.
  EXPECT_THAT(rows_of(*results.table("pathological"), "problem,runs,solved,threw,found"),
              Contains("pathological-throws | 2 | 1 | 1 | 2"));
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
/// chance-a solves at the high friction only; the others never solve, and throw.
TEST(Machines, HaveMapsOverTheirConstantsAndALandscapeEach) {
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
  const Plan plan = plan_from(
      part_of("\"*\"",
              "solvers = [\"chance-*\"]\nbudgets = [100]\ninstances = 1\n"
              "machines = {around = \"C1\", restitution = [0.1, 0.9], friction = [0, 1]}"),
      "test");
  const MadeUp made(searched_campaign(plan, catalogue), [](const PlannedCell& cell) {
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
  EXPECT_THAT(known.heat_map->rows, ElementsAre(ElementsAre(0, 0.9), ElementsAre(0, 0.1)));
  EXPECT_EQ(known.title, "bowl: best known values of 0 to 0.9");
  const report::Chart& landscape = *page.chart("landscape");
  const Problem& stated = made.campaign.problems().front();
  EXPECT_EQ(landscape.x.categories.front(), fmt::format("{:.3g}", stated.lower[0]));
  EXPECT_EQ(landscape.x.categories.back(), fmt::format("{:.3g}", stated.upper[0]));
  ASSERT_EQ(landscape.heat_map->rows.size(), 4U);
  EXPECT_EQ(landscape.y.categories[1], "friction 0, restitution 0.9");
  const auto& row = landscape.heat_map->rows[1];
  ASSERT_EQ(row.size(), landscape.x.categories.size());
  EXPECT_EQ(row.front(), true_values_at(stated, stated.lower).objective);
  EXPECT_EQ(row.back(), true_values_at(stated, stated.upper).objective);
  const auto levels = rows_of(*page.table("levels"), "changed,setting,first,returned,same");
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_THAT(levels[0], StartsWith("friction | 0 | none | ")) << "at no friction nobody solves";
  EXPECT_EQ(levels[1], "friction | 1 | chance-a, original | 1 | no");
}

// Whoever reads a name must know that the solver was tuned on what it is compared on.
TEST(SolverFacts, HaveTheSettingsAndTheKindOfEverySolverOfTheSuiteAndSayWhetherItWasTunedToIt) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_NE(kind_of(solver.name), "other") << solver.name;
    const SolverSettings settings = settings_of(solver.name).value();
    const bool named_so = solver.name.ends_with("-tuned");
    const bool says = settings.from.find("tuned to this suite") != std::string::npos ||
                      settings.from.find("did best here") != std::string::npos || named_so;
    EXPECT_TRUE(settings.tuned || !says) << solver.name;
    EXPECT_EQ(tuned_mark(solver.name).empty(), !settings.tuned || named_so) << solver.name;
  }
  for (const MissingSolver& missing : missing_solvers()) {
    EXPECT_TRUE(settings_of(missing.solver).has_value()) << missing.solver;
  }
  EXPECT_EQ(settings_of("ipopt-tuned")->from, "tuned to this suite");
  EXPECT_EQ(settings_of("ipopt")->from, "Ipopt");
  EXPECT_EQ(tuned_mark("continuation-nlopt-slsqp"), " (tuned to this suite)");
  EXPECT_EQ(kind_of("fireworks-authors"), "fireworks");
  EXPECT_EQ(kind_of("nlopt-auglag-bobyqa"), "models");
  EXPECT_EQ(kind_of("nlopt-auglag-lbfgs"), "derivatives");
  EXPECT_FALSE(settings_of("hill-climber").has_value()) << "a user's";
  EXPECT_EQ(kind_of("hill-climber"), "other");
}

TEST(SolverFacts, SayHowOldALibraryIsAndWhichSolversAreOfIt) {
  EXPECT_THAT(library_note("Ipopt 3.11.9"), HasSubstr("2014"));
  EXPECT_EQ(library_note("Ipopt 3.14.0"), "");
  EXPECT_EQ(library_note("NLopt 2.7.1"), "");
  std::vector<Solver> solvers = {chance("mads"), chance("ipopt"), chance("ipopt-tuned")};
  EXPECT_THAT(rows_of(library_notes(solvers), "version"), ElementsAre());
  solvers[1].version = solvers[2].version = "Ipopt 3.11.9";
  EXPECT_THAT(rows_of(library_notes(solvers), "version,solvers"),
              ElementsAre("Ipopt 3.11.9 | ipopt, ipopt-tuned"));
}

Outcome ending(Outcome outcome, const std::string& reason) {
  outcome.terminations = {reason};
  return outcome;
}

report::Results solver_pages_of(const std::string& plan, const RunsOf& runs_of) {
  const MadeUp made(plan, runs_of);
  const auto sets = made.sets();
  return solvers_page(made.campaign, made.results, sets, speed_accuracy_table(made.campaign, sets),
                      leader_table(made.rated()));
}

report::Results page_of_solver(const report::Results& all, const std::string& solver) {
  return std::ranges::find(all.parts.at("solvers"), solver, &report::Part::id)->results;
}

/// On bowls of 1, 2 and 8 variables: chance-a solves one of two runs of the first, after 10, and
/// both of the second, after 40; chance-b both of the first, after 50; luck and all others nothing.
TEST(SolverPages, HaveWhatTheReturnedPointsSolvedWithTheLargestBudget) {
  const auto runs_of = [](const PlannedCell& cell) {
    const auto both = [](std::optional<std::int64_t> first, std::optional<std::int64_t> second) {
      return std::vector{ending(run_of(first), "short"),
                         ending(run_of(second), first ? "short" : "spent")};
    };
    if (cell.cell.budget == 5) return both({}, {});
    const std::string on = cell.cell.solver + " on " + cell.cell.problem;
    if (on == "chance-a on bowl-1") return both(10, {});
    if (on == "chance-a on bowl-2") return both(40, 40);
    if (on == "chance-b on bowl-1") return both(50, 50);
    return both({}, {});
  };
  const report::Results all = solver_pages_of(
      part_of("\"bowl-[128]\"", "solvers = \"*\"\nbudgets = [5, 100]\ninstances = 2"), runs_of);
  EXPECT_THAT(
      rows_of(*all.table("solvers"), "solver,solved,problems,families,fronts,first"),
      ElementsAre("chance-a | 2 | 3 | 1 | bowl | bowl", StartsWith("chance-b | 1 | 3 | 1 | "),
                  StartsWith("luck | 0 | 3 | 1 |  | ")));
  const auto reasons = rows_of(*all.table("terminations"), "solver,reason,times,share");
  EXPECT_THAT(reasons.front(), StartsWith("chance-a | short | 8 | ")) << "of all runs";
  EXPECT_THAT(reasons, testing::IsSupersetOf({"luck | short | 6 | 0.5", "luck | spent | 6 | 0.5"}));
  const report::Results luck = page_of_solver(all, "luck"), own = page_of_solver(all, "chance-a");
  EXPECT_EQ(*luck.value("summary"),
            Value("It solved 0 of the 3 problems that it takes. It is furthest behind on bowl-1 (0 "
                  "%; chance-b 100 %)."));
  EXPECT_EQ(*own.value("summary"),
            Value("It solved 2 of the 3 problems that it takes. It is first by mean rank on bowl. "
                  "It is furthest behind on bowl-1 (50 %; chance-b 100 %)."));
  EXPECT_TRUE(is_missing(*luck.value("settings"))) << "none of the suite";
  EXPECT_EQ(*luck.value("ends"), Value("short 50 %; spent 50 %"));
  EXPECT_THAT(rows_of(*luck.table("families"), "running_time,front"),
              ElementsAre("- | chance-a 50 %"));
  const Table& families = *own.table("families");
  EXPECT_THAT(rows_of(families, "family,share,solved,front"),
              ElementsAre("bowl | 0.5 | 2 | on the front"));
  // (10 + 100) / 1 of one variable, as a run in two solved; 40 / 2 of two: the mean is geometric.
  EXPECT_NEAR(families[0].number("running_time"), std::sqrt(110.0 * 20.0), 1e-9);
}

TEST(SolverPages, HaveTheFamiliesOnWhoseFrontTheSolverIsFirstThenThoseFurthestBehind) {
  // chance-a is far behind on bowls, and alone on cups.
  const auto runs_of = [](const PlannedCell& cell) {
    const bool solves = (cell.cell.problem == "cup-s") == (cell.cell.solver == "chance-a");
    return twice(ending(solves ? run_of(9) : run_of({}), "spent"));
  };
  const report::Results all =
      solver_pages_of(two_runs(R"(["bowl-1", "bowl-2", "cup-s"])", "chance-*"), runs_of);
  EXPECT_THAT(rows_of(*page_of_solver(all, "chance-a").table("families"), "family,on_front,behind"),
              ElementsAre(StartsWith("cup | yes | "), "bowl | no | 1"));
}

}  // namespace
}  // namespace ricochet::studies::comparison
