#include "src/experiment/archive.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "tests/support/files.h"
#include "tests/experiment/store/stored_runs.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A run whose feasible improvements have these objectives, after 1, 2, ... evaluations.
RunRecord record_of(const std::vector<double>& objectives) {
  RunRecord record;
  record.seed = 7;
  record.ledger.seconds = 0.12345;
  for (const double objective : objectives) {
    record.trace.push_back({static_cast<std::int64_t>(record.trace.size()) + 1,
                            0.0123456,
                            {objective, 0.0},
                            Vector::Ones(2)});
  }
  return record;
}

StoredProblem problem_of(double best_known, double tolerance) {
  StoredProblem problem;
  problem.best_known = best_known;
  problem.tolerance = tolerance;
  return problem;
}

std::vector<double> objectives_of(const RunRecord& record) {
  std::vector<double> objectives;
  for (const Improvement& step : record.trace) objectives.push_back(step.true_values.objective);
  return objectives;
}

TEST(Archive, KeepsImprovementsToAHundredthTheFirstThatSolvesAndTheLast) {
  const RunRecord thin =
      thinned(record_of({401, 400, 50, 5, 4.5, 1.2, 1.1, 1.05}), problem_of(1, 0.5));
  EXPECT_THAT(objectives_of(thin), ElementsAre(404, 5, 1.2, 1.05));
  EXPECT_EQ(thin.seed, 0U);
  EXPECT_DOUBLE_EQ(thin.ledger.seconds, 0.12);
  for (const Improvement& step : thin.trace) {
    EXPECT_EQ(step.x.size(), 0);
    const bool solves = step.true_values.objective == 1.2;
    EXPECT_DOUBLE_EQ(step.seconds, solves ? 0.012 : 0);
  }
}

TEST(Archive, KeepsTheFirstAsGoodAsTheReturnedPoint) {
  RunRecord record = record_of({11, 10, 9, 8});
  record.returned = ReturnedPoint{Vector::Ones(2), {9.5, 0.0}};
  const RunRecord thin = thinned(record, problem_of(1, 0));
  EXPECT_THAT(objectives_of(thin), ElementsAre(11, 9, 8));
  EXPECT_EQ(thin.returned->x.size(), 0);
  EXPECT_EQ(thin.returned->true_values.objective, 9.5);
}

TEST(Archive, RoundsUpWhatDoesNotSolveAndKeepsItsOrder) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> gaps(0, 5);
  for (int k = 0; k < 1000; ++k) {
    const double best = k % 2 == 0 ? 0 : gaps(random);
    std::vector<double> objectives;
    for (int step = 0; step < 9; ++step) objectives.push_back(best + gaps(random));
    std::ranges::sort(objectives, std::greater());
    RunRecord record = record_of(objectives);
    record.returned = ReturnedPoint{Vector::Ones(2), {objectives[4], 0.0}};
    const StoredProblem problem = problem_of(best, 1e-6);
    const RunRecord thin = thinned(record, problem);
    for (const Improvement& step : thin.trace) {
      const double before = objectives[static_cast<std::size_t>(step.evaluations) - 1];
      const double after = step.true_values.objective;
      const bool at_the_end = step.evaluations == 9 || before == objectives[4];
      EXPECT_GE(after, before);
      EXPECT_LE(after - before, (before - best) * (at_the_end ? 2e-6 : 0.04));
      EXPECT_TRUE(before - best > 1e-6 || after == before);
    }
    EXPECT_TRUE(std::ranges::is_sorted(objectives_of(thin), std::greater()));
    const double returned = thin.returned->true_values.objective;
    EXPECT_NEAR(returned, objectives[4], 2e-6 * (objectives[4] - best));
    EXPECT_EQ(std::ranges::count(objectives_of(thin), returned), 1) << "the first as good stays";
  }
}

TEST(Archive, KeepsValuesThatAreTooLargeToRound) {
  const double largest = std::numeric_limits<double>::max();
  EXPECT_THAT(objectives_of(thinned(record_of({largest, 1.5, 1.25}), problem_of(1, 0))),
              ElementsAre(largest, 1.5, 1.25));
}

TEST(Archive, KeepsTheFirstFeasiblePoint) {
  RunRecord record = record_of({1, 2, 9, 8});
  record.trace[0].true_values.violation = 2;
  record.trace[1].true_values.violation = 1;
  EXPECT_THAT(objectives_of(thinned(record, problem_of(0, 0))), ElementsAre(9, 8));
}

class ArchiveFile : public TemporaryFolder {
 protected:
  const fs::path store_ = folder_ / "runs.sqlite";
  const fs::path archive_ = folder_ / "runs.archive";

  void SetUp() override {
    TemporaryFolder::SetUp();
    std::mt19937_64 random(3);
    Store store = Store::create(store_, a_description());
    for (int k = 0; k < 60; ++k) store.add(a_key(k), any_record(random));
  }
};

TEST_F(ArchiveFile, IsReadAsAStoreOfTheThinnedRuns) {
  const Store store = Store::open(store_, Store::For::reading);
  const auto wanted = [](const RunKey& key) { return key.cell.solver == "fast"; };
  write_archive(store, archive_, wanted, {{"citation", "Somebody, 2026"}});
  EXPECT_TRUE(is_archive(archive_));
  EXPECT_FALSE(is_archive(store_));
  EXPECT_LT(fs::file_size(archive_), fs::file_size(store_) / 2);
  const Store archive = Store::open(archive_, Store::For::reading);
  EXPECT_TRUE(is_archived(archive.description()));
  EXPECT_FALSE(is_archived(store.description()));
  EXPECT_EQ(archive.description().made.at("citation"), "Somebody, 2026");
  EXPECT_EQ(archive.description().problems, store.description().problems);
  std::map<RunKey, RunRecord> runs;
  archive.each([&](const StoredRun& run) { runs[run.key] = run.record; });
  std::size_t kept = 0;
  store.each([&](const StoredRun& run) {
    if (!wanted(run.key)) return;
    ++kept;
    const auto& problems = store.description().problems;
    const auto problem = std::ranges::find(problems, run.key.cell.problem, &StoredProblem::name);
    expect_kept(runs.at(run.key), thinned(run.record, *problem));
  });
  EXPECT_GT(kept, 10U);
  EXPECT_EQ(runs.size(), kept);
}

TEST_F(ArchiveFile, IsRefusedIfItIsDamagedOrOpenedForAdding) {
  write_archive(Store::open(store_, Store::For::reading), archive_,
                [](const RunKey&) { return true; });
  EXPECT_THROW(Store::open(archive_, Store::For::adding), InputError);
  std::ifstream in(archive_, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  bytes[bytes.size() / 2] ^= 1;
  write_text_file(archive_, bytes);
  EXPECT_THAT([&] { Store::open(archive_, Store::For::reading); },
              ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr(archive_.string()), HasSubstr("damaged or cut off"))));
}

/// One that grows without end, has something behind its end or holds what is no store is refused
/// under its own name.
TEST_F(ArchiveFile, IsRefusedIfAStrangerMadeItOtherwise) {
  write_archive(Store::open(store_, Store::For::reading), archive_,
                [](const RunKey&) { return true; });
  std::ifstream in(archive_, std::ios::binary);
  const std::string ours(std::istreambuf_iterator<char>(in), {});
  const fs::path touched = folder_ / "touched.sqlite";
  Store::create(touched, a_description());
  SQLite::Database(touched.string(), SQLite::OPEN_READWRITE)
      .exec("CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM run; END");
  std::ifstream store(touched, std::ios::binary);
  const std::string with_trigger(std::istreambuf_iterator<char>(store), {});
  const std::string sparse = with_trigger + std::string(30'000'000, '\0');
  for (const auto& [bytes, words] :
       {std::pair{xz_compressed(std::string(200'000'000, '\0')), "holds more than"},
        std::pair{xz_compressed(sparse), "holds more than"},
        std::pair{ours + "x", "has 1 bytes behind its end"},
        std::pair{ours + ours, "behind its end"},
        std::pair{xz_compressed("text"), "file is not a database"},
        std::pair{xz_compressed(""), "it is empty"},
        std::pair{xz_compressed(with_trigger), "it has a trigger t that no store has"}}) {
    write_text_file(archive_, bytes);
    EXPECT_THAT([&] { Store::open(archive_, Store::For::reading); },
                ThrowsMessage<InputError>(testing::AllOf(
                    testing::StartsWith(archive_.string() + ": "), HasSubstr(words))));
  }
}

}  // namespace
}  // namespace ricochet
