#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "src/analysis/comparison/sections.h"
#include "tests/support/files.h"

namespace ricochet::studies::comparison {
namespace {

using testing::ElementsAre;

/// Stores of two solvers on eight problems of two variables, with two runs on each.
class EntryChangesOfStores : public TemporaryFolder {
 protected:
  static constexpr int problems = 8;

  /// Evaluations until a run of a solver on a problem is solved; 0: it is not.
  using Until = std::function<int(const std::string& solver, int problem, int instance)>;

  Store store_of(const std::string& name, const std::string& version, const Until& until,
                 const std::string& hash_of_last = "same") {
    std::filesystem::create_directories(folder_);
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
          for (int instance : {1, 2})
            store.add({cell, instance, 0}, run(until(solver, q, instance)));
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
  EXPECT_EQ(a.solver, "a");
  EXPECT_EQ(a.version + " " + a.other_version, "1 2");
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
TEST_F(EntryChangesOfStores, CountRunsThatDidNotSolveAsTenBudgets) {
  const Store first = store_of("1", "1", [](auto, int, int) { return 20; });
  const Store second =
      store_of("2", "1", [](auto, int, int instance) { return instance == 1 ? 20 : 0; });
  EXPECT_NEAR(entry_changes(first, second).entries[0].ratio, (20 + 10 * 100) / 40.0, 1e-9);
}

TEST_F(EntryChangesOfStores, LeaveOutProblemsThatAreOthers) {
  const auto until = [](auto, int, int) { return 20; };
  const Store first = store_of("1", "1", until);
  const Store second = store_of("2", "1", until, "other");
  const EntryChanges changes = entry_changes(first, second);
  EXPECT_THAT(changes.other_problems, ElementsAre(std::to_string(problems - 1)));
  EXPECT_EQ(changes.entries[0].problems, problems - 1);
}

}  // namespace
}  // namespace ricochet::studies::comparison
