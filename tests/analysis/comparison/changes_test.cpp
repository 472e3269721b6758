#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"
#include "src/experiment/stored_campaign.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet::studies::comparison {
namespace {

using testing::ElementsAre;

/// Six walkers end the further from the best point the higher their number, or, where it does not
/// rise, the lower; the nearest solves the problem. What the report says of their runs.
Table changes_of(const std::string& plan, Catalogue catalogue,
                 bool (*rises)(const std::string& problem)) {
  catalogue.own_solver = nullptr;
  catalogue.solvers.clear();
  for (int k = 1; k <= 6; ++k) catalogue.solvers.push_back(chance("walker-" + std::to_string(k)));
  const MadeUp made(searched_campaign(plan_from(plan, "test"), catalogue),
                    [rises](const PlannedCell& cell) {
                      const int number = cell.cell.solver.back() - '0';
                      const int rank = rises(cell.cell.problem) ? number - 1 : 6 - number;
                      Outcome outcome = rank == 0 ? run_of(1) : run_of({});
                      outcome.verdict.returned_optimality_gap = 1e-4 * rank * rank;
                      return twice(outcome);
                    });
  const std::vector<RatedPart> parts = made.rated();
  const Table changes = change_table(made.campaign, made.results, parts);
  return changes.rows.empty() ? level_table(parts[0].comparison, parts[0].groups[0]) : changes;
}

TEST(Changes, OfTheFidelityTurnTheOrderOver) {
  Catalogue catalogue = made_up_catalogue();
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
      part_of("\"*\"",
              "solvers = \"*\"\nbudgets = 20\ninstances = 2\n"
              "machines = {around = \"C1\", fidelity = [\"impact\", \"compliant\", \"planar\"]}"),
      catalogue, [](const std::string& problem) { return !problem.ends_with("planar"); });
  // The restitution is the same everywhere. There is one problem a level.
  EXPECT_THAT(rows_of(rows, "changed,family,entries,setting,first,correlation,best,problems"),
              ElementsAre("fidelity | bowl | 6 | impact | walker-1, original | - | - | 1",
                          "fidelity | bowl | 6 | compliant | walker-1, original | 1 | - | 1",
                          "fidelity | bowl | 6 | planar | walker-6, original | -1 | - | 1"));
  EXPECT_TRUE(rows[1].is("same"));
  EXPECT_EQ(rows[2]["same"], Value(false));
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

TEST(LevelName, IsThatOfTheFidelity) {
  EXPECT_EQ(level_name("fidelity", 1), "compliant");
  EXPECT_EQ(level_name("restitution", 0.5), "0.5");
}

/// Stores of two solvers on eight problems of two variables, with two runs on each.
class EntryChangesOfStores : public TemporaryFolder {
 protected:
  static constexpr int problems = 8;

  /// Evaluations until a run of a solver on a problem is solved; 0: it is not.
  using Until = std::function<int(const std::string& solver, int problem, int instance)>;

  Store store_of(const std::string& name, const std::string& version, const Until& until,
                 const std::string& hash_of_last = "same") {
    CampaignDescription description;
    for (int q = 0; q < problems; ++q) {
      StoredProblem problem{std::to_string(q), "family", "", 2, 0, 0, 0.5, 0, {}};
      problem.hash = q + 1 < problems ? "same" : hash_of_last;
      description.problems.push_back(problem);
    }
    description.solvers = {{"a", version}, {"b", "1"}};
    Store store = Store::create(folder_ / name, description);
    for (const char* solver : {"a", "b"}) {
      for (int q = 0; q < problems; ++q) {
        for (const int budget : {5, 50}) {
          const Cell cell{std::to_string(q), "original", "plain", solver, budget, "n"};
          for (int instance : {1, 2}) {
            store.add({cell, instance, 0}, run(until(solver, q, instance)));
          }
        }
      }
    }
    return store;
  }

  static RunRecord run(int until) {
    RunRecord record;
    record.ledger.charged = 100;
    const TrueValues values{until > 0 ? 0.0 : 1.0, 0};
    record.trace = {{until > 0 ? until : 1, 0, values, Vector::Zero(2)}};
    record.returned = ReturnedPoint{Vector::Zero(2), values};
    return record;
  }
};

/// Half as many evaluations on all of eight problems: p = 2 / 2^8, twice that with Holm's
/// correction over two entries.
TEST_F(EntryChangesOfStores, AreSureIfAllProblemsAgree) {
  const Store first = store_of("1", "1", [](auto, int q, int) { return 20 + 2 * q; });
  const Store second = store_of("2", "2", [](const auto& solver, int q, int) {
    return (20 + 2 * q) / (solver == "a" ? 2 : 1);
  });
  const EntryChanges changes = entry_changes(first, second);
  ASSERT_EQ(changes.entries.size(), 2U);
  const EntryChange& a = changes.entries[0];
  EXPECT_EQ(a.solver + " " + a.version + " " + a.other_version, "a 1 2");
  EXPECT_EQ(a.problems, problems);
  EXPECT_EQ(a.cheaper, problems);
  EXPECT_EQ(a.dearer, 0);
  EXPECT_NEAR(a.ratio, 0.5, 1e-12);
  EXPECT_NEAR(a.p_value, 2 * 2 / 256.0, 1e-12);
  EXPECT_TRUE(a.sure());
  const EntryChange& b = changes.entries[1];
  EXPECT_TRUE(b.same());
  EXPECT_EQ(b.ratio, 1);
  EXPECT_EQ(b.p_value, 1);
  EXPECT_FALSE(b.sure());
}

TEST_F(EntryChangesOfStores, AreNotSureIfProblemsDisagree) {
  const Store first = store_of("1", "1", [](auto, int, int) { return 20; });
  const Store second = store_of("2", "1", [](auto, int q, int) { return q % 2 == 0 ? 10 : 40; });
  for (const EntryChange& change : entry_changes(first, second).entries) {
    EXPECT_EQ(change.cheaper, 4);
    EXPECT_EQ(change.dearer, 4);
    EXPECT_NEAR(change.ratio, 1, 1e-12);
    EXPECT_FALSE(change.sure());
  }
}

/// The second instance is no longer solved: it counts as ten budgets of 50 for each of 2 variables.
/// The last problem is another.
TEST_F(EntryChangesOfStores, CountRunsThatDidNotSolveAsTenBudgets) {
  const Store first = store_of("1", "1", [](auto, int, int) { return 20; });
  const Store second = store_of(
      "2", "1", [](auto, int, int instance) { return instance == 1 ? 20 : 0; }, "other");
  const EntryChanges changes = entry_changes(first, second);
  EXPECT_NEAR(changes.entries[0].ratio, (20 + 10 * 100) / 40.0, 1e-9);
  EXPECT_THAT(changes.other_problems, ElementsAre("7"));
  EXPECT_EQ(changes.entries[0].problems, problems - 1);
}

}  // namespace
}  // namespace ricochet::studies::comparison
