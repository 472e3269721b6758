#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/experiment/stored_campaign.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/files.h"

namespace ricochet::studies::comparison {
namespace {

/// Six walkers end the further from the best point the higher their number, or, where it does not
/// rise, the lower; the nearest solves the problem. What the report says of their runs.
Table changes_of(const std::string& plan, Catalogue catalogue,
                 bool (*rises)(const std::string& problem)) {
  catalogue.own_solver = nullptr;
  catalogue.solvers.clear();
  for (int k = 1; k <= 6; ++k) catalogue.solvers.push_back(chance("walker-" + std::to_string(k)));
  const auto runs_of = [rises](const PlannedCell& cell) {
    const int number = cell.cell.solver.back() - '0';
    const int rank = rises(cell.cell.problem) ? number - 1 : 6 - number;
    Outcome outcome = rank == 0 ? run_of(1) : run_of({});
    outcome.verdict.returned_optimality_gap = 1e-4 * rank * rank;
    return twice(outcome);
  };
  const MadeUp made(searched_campaign(plan_from(plan, "test"), catalogue), runs_of);
  const std::vector<RatedPart> parts = made.rated();
  const Table changes = change_table(made.campaign, made.results, parts);
  return changes.rows.empty() ? level_table(parts[0].comparison, parts[0].groups[0]) : changes;
}

TEST(Changes, OfTheFidelityTurnTheOrderOver) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [](const MachineGrid& grid) {
    std::vector<SearchedProblem> problems;
    double number = 0;
    for (const OptionValue& level : grid.levels.at("fidelity")) {
      Problem problem = bowl("bowl-" + std::get<std::string>(level), 1);
      problem.machine = std::get<std::string>(level);
      problem.factors = {{"fidelity", number++}, {"restitution", 0.5}};
      problems.push_back(searched(problem, nullptr));
    }
    return problems;
  };
  const Table rows = changes_of(
      part_of("\"*\"",
              "solvers = \"*\"\nbudgets = 20\ninstances = 2\n"
              "machines = {around = \"C1\", fidelity = [\"impact\", \"compliant\", \"planar\"]}"),
      catalogue, [](const std::string& problem) { return !problem.ends_with("planar"); });
  // The restitution is the same everywhere. There is one problem a level.
  EXPECT_THAT(
      rows_of(rows, "changed,family,entries,setting,first,correlation,best,problems,same"),
      ElementsAre(StartsWith("fidelity | bowl | 6 | impact | walker-1, original | - | - | 1 | "),
                  "fidelity | bowl | 6 | compliant | walker-1, original | 1 | - | 1 | yes",
                  "fidelity | bowl | 6 | planar | walker-6, original | -1 | - | 1 | no"));
}

TEST(Changes, OfSmoothingAndPriceAreComparedWithTheUsualOnes) {
  const Table rows =
      changes_of(part_of("\"cup-s\"",
                         "solvers = \"*\"\nbudgets = 20\ninstances = 2\nsmoothings = [0.125, 1]\n"
                         "formulations = \"surrogate*\"\ngradient_prices = [0, \"n\"]"),
                 made_up_catalogue(), [](const std::string&) { return true; });
  EXPECT_THAT(rows_of(rows, "changed,setting,same"),
              ElementsAre("price of a gradient | n | yes", "price of a gradient | 0 | yes",
                          "smoothing of the surrogate | 0.5 | yes",
                          "smoothing of the surrogate | 0.125 | yes",
                          "smoothing of the surrogate | 1 | yes"));
  EXPECT_EQ(rows_of(rows, "entries,first,correlation")[3], "6 | walker-1 | 1")
      << "those that are shown this smoothing alone";
}

/// Stores of two solvers on eight problems of two variables, with two runs on each.
class EntryChangesOfStores : public TemporaryFolder {
 protected:
  /// Evaluations until a run of a solver on a problem is solved; 0: it is not.
  using Until = std::function<int(const std::string& solver, int problem, int instance)>;

  Store store_of(const std::string& name, const std::string& version, const Until& until,
                 const std::string& hash_of_last = "same") {
    CampaignDescription description;
    for (int q = 0; q < 8; ++q) {
      StoredProblem problem{std::to_string(q), "family", "", 2, 0, 0, 0.5, 0, {}};
      problem.hash = q < 7 ? "same" : hash_of_last;
      description.problems.push_back(problem);
    }
    description.solvers = {{"a", version}, {"b", "1"}};
    Store store = Store::create(folder_ / name, description);
    for (const char* solver : {"a", "b"}) {
      for (int q = 0; q < 8; ++q) {
        for (const int budget : {5, 50}) {
          const Cell cell{std::to_string(q), "original", "plain", solver, budget, "n"};
          for (int instance : {1, 2}) {
            const int after = until(solver, q, instance);
            const TrueValues values{after > 0 ? 0.0 : 1.0, 0};
            RunRecord record;
            record.ledger.charged = 100;
            record.trace = {{std::max(after, 1), 0, values, Vector::Zero(2)}};
            record.returned = ReturnedPoint{Vector::Zero(2), values};
            store.add({cell, instance, 0}, record);
          }
        }
      }
    }
    return store;
  }
};

std::vector<std::string> texts_of(const std::vector<EntryChange>& changes) {
  std::vector<std::string> texts;
  for (const EntryChange& c : changes) {
    texts.push_back(fmt::format("{} {} to {}: {} cheaper, {} dearer of {}, ratio {:.9g}, sure: {}",
                                c.solver, c.version, c.other_version, c.cheaper, c.dearer,
                                c.problems, c.ratio, c.sure()));
  }
  return texts;
}

/// Half as many evaluations on all of eight problems: p = 2 / 2^8, twice that with Holm's
/// correction over two entries.
TEST_F(EntryChangesOfStores, AreSureIfAllProblemsAgree) {
  const Store first = store_of("1", "1", [](auto, int q, int) { return 20 + 2 * q; });
  const Store second = store_of("2", "2", [](const auto& solver, int q, int) {
    return (20 + 2 * q) / (solver == "a" ? 2 : 1);
  });
  const EntryChanges changes = entry_changes(first, second);
  EXPECT_THAT(texts_of(changes.entries),
              ElementsAre("a 1 to 2: 8 cheaper, 0 dearer of 8, ratio 0.5, sure: true",
                          "b 1 to 1: 0 cheaper, 0 dearer of 8, ratio 1, sure: false"));
  EXPECT_NEAR(changes.entries[0].p_value, 2 * 2 / 256.0, 1e-12);
  EXPECT_EQ(changes.entries[1].p_value, 1);
  EXPECT_TRUE(changes.entries[1].same());
}

TEST_F(EntryChangesOfStores, AreNotSureIfProblemsDisagree) {
  const Store first = store_of("1", "1", [](auto, int, int) { return 20; });
  const Store second = store_of("2", "1", [](auto, int q, int) { return q % 2 == 0 ? 10 : 40; });
  EXPECT_THAT(texts_of(entry_changes(first, second).entries),
              ElementsAre("a 1 to 1: 4 cheaper, 4 dearer of 8, ratio 1, sure: false",
                          "b 1 to 1: 4 cheaper, 4 dearer of 8, ratio 1, sure: false"));
}

/// The second instance is no longer solved: it counts as ten budgets of 50 for each of 2 variables.
/// The last problem is another.
TEST_F(EntryChangesOfStores, CountRunsThatDidNotSolveAsTenBudgets) {
  const Store first = store_of("1", "1", [](auto, int, int) { return 20; });
  const auto until = [](auto, int, int instance) { return instance == 1 ? 20 : 0; };
  const EntryChanges changes = entry_changes(first, store_of("2", "1", until, "other"));
  EXPECT_NEAR(changes.entries[0].ratio, (20 + 10 * 100) / 40.0, 1e-9);
  EXPECT_THAT(changes.other_problems, ElementsAre("7"));
  EXPECT_EQ(changes.entries[0].problems, 7);
}

}  // namespace
}  // namespace ricochet::studies::comparison
