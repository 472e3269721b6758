#include "src/experiment/archive.h"

#include <SQLiteCpp/Database.h>

#include "tests/experiment/store/stored.h"

namespace ricochet {
namespace {

/// A run whose feasible improvements have these objectives, after 1, 2, ... evaluations.
RunRecord improving(const std::vector<double>& objectives) {
  RunRecord record;
  record.seed = 7;
  record.ledger.seconds = 0.12345;
  for (std::int64_t evaluations = 1; const double objective : objectives) {
    record.trace.push_back({evaluations++, 0.0123456, {objective, 0.0}, Vector::Ones(2)});
  }
  return record;
}

/// What an archive keeps of it.
RunRecord thinned(const RunRecord& record, double best_known, double tolerance) {
  StoredProblem problem;
  problem.best_known = best_known;
  problem.tolerance = tolerance;
  return thinned(record, problem);
}

std::vector<double> objectives_of(const RunRecord& record) {
  std::vector<double> objectives;
  for (const Improvement& step : record.trace) objectives.push_back(step.true_values.objective);
  return objectives;
}

TEST(Archive, KeepsImprovementsToAHundredthTheFirstThatSolvesAndTheLast) {
  const RunRecord thin = thinned(improving({401, 400, 50, 5, 4.5, 1.2, 1.1, 1.05}), 1, 0.5);
  EXPECT_THAT(objectives_of(thin), ElementsAre(404, 5, 1.2, 1.05));
  EXPECT_EQ(thin.seed, 0U);
  EXPECT_DOUBLE_EQ(thin.ledger.seconds, 0.12);
  for (const Improvement& step : thin.trace) {
    EXPECT_EQ(step.x.size(), 0);
    const bool solves = step.true_values.objective == 1.2;
    EXPECT_DOUBLE_EQ(step.seconds, solves ? 0.012 : 0);
  }
}

TEST(Archive, KeepsTheFirstFeasibleThoseTooLargeToRoundAndTheFirstAsGoodAsTheReturnedPoint) {
  RunRecord record = improving({11, 10, 9, 8});
  record.returned = ReturnedPoint{Vector::Ones(2), {9.5, 0.0}};
  const RunRecord thin = thinned(record, 1, 0);
  EXPECT_THAT(objectives_of(thin), ElementsAre(11, 9, 8));
  EXPECT_EQ(thin.returned->x.size(), 0);
  EXPECT_EQ(thin.returned->true_values.objective, 9.5);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_THAT(objectives_of(thinned(improving({largest, 1.5, 1.25}), 1, 0)),
              ElementsAre(largest, 1.5, 1.25));
  record = improving({1, 2, 9, 8});
  record.trace[0].true_values.violation = 2;
  record.trace[1].true_values.violation = 1;
  EXPECT_THAT(objectives_of(thinned(record, 0, 0)), ElementsAre(9, 8));
}

TEST(Archive, RoundsUpWhatDoesNotSolveAndKeepsItsOrder) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> gaps(0, 5);
  for (int k = 0; k < 1000; ++k) {
    const double best = k % 2 == 0 ? 0 : gaps(random);
    std::vector<double> objectives;
    for (int step = 0; step < 9; ++step) objectives.push_back(best + gaps(random));
    std::ranges::sort(objectives, std::greater());
    RunRecord record = improving(objectives);
    record.returned = ReturnedPoint{Vector::Ones(2), {objectives[4], 0.0}};
    const RunRecord thin = thinned(record, best, 1e-6);
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

class ArchiveFile : public TemporaryFolder {
 protected:
  const fs::path store_ = folder_ / "runs.sqlite";
  const fs::path archive_ = folder_ / "runs.archive";

  void SetUp() override {
    TemporaryFolder::SetUp();
    Store store = Store::create(store_, a_description());
    add(store, any_records(60, 3));
  }

  /// The bytes of an archive of all runs.
  std::string archived() const {
    write_archive(reading(store_), archive_, [](const RunKey&) { return true; });
    return text_of(archive_);
  }

  /// Expects that an archive of these bytes is refused under its own name.
  void expect_refused(const std::string& bytes, const std::string& words) const {
    write_file(archive_, bytes);
    EXPECT_THAT(complaint_of([&] { return reading(archive_); }),
                AllOf(StartsWith(archive_.string() + ": "), HasSubstr(words)));
  }
};

TEST_F(ArchiveFile, IsReadAsAStoreOfTheThinnedRuns) {
  const Store store = reading(store_);
  const auto wanted = [](const RunKey& key) { return key.cell.solver == "fast"; };
  write_archive(store, archive_, wanted, {{"citation", "Somebody, 2026"}});
  EXPECT_TRUE(is_archive(archive_));
  EXPECT_FALSE(is_archive(store_));
  EXPECT_LT(fs::file_size(archive_), fs::file_size(store_) / 2);
  const Store archive = reading(archive_);
  EXPECT_TRUE(is_archived(archive.description()));
  EXPECT_FALSE(is_archived(store.description()));
  EXPECT_EQ(archive.description().made.at("citation"), "Somebody, 2026");
  EXPECT_EQ(archive.description().problems, store.description().problems);
  std::map<RunKey, std::vector<std::string>> thin;
  store.each([&](const StoredRun& run) {
    const auto& problems = store.description().problems;
    const auto problem = std::ranges::find(problems, run.key.cell.problem, &StoredProblem::name);
    if (wanted(run.key)) thin[run.key] = bits_of(thinned(run.record, *problem));
  });
  EXPECT_GT(thin.size(), 10U);
  EXPECT_EQ(bits_of(archive), thin);
}

TEST_F(ArchiveFile, IsRefusedIfItIsDamagedOrOpenedForAdding) {
  std::string bytes = archived();
  EXPECT_THROW(adding(archive_), InputError);
  bytes[bytes.size() / 2] ^= 1;
  expect_refused(bytes, "damaged or cut off");
}

/// One that grows without end, has something behind its end or holds what is no store is refused
/// under its own name.
TEST_F(ArchiveFile, IsRefusedIfAStrangerMadeItOtherwise) {
  const std::string ours = archived();
  const fs::path touched = folder_ / "touched.sqlite";
  Store::create(touched, a_description());
  SQLite::Database(touched.string(), SQLite::OPEN_READWRITE)
      .exec("CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM run; END");
  const std::string with_trigger = text_of(touched);
  const std::string sparse = with_trigger + std::string(30'000'000, '\0');
  expect_refused(xz_compressed(std::string(200'000'000, '\0')), "holds more than");
  expect_refused(xz_compressed(sparse), "holds more than");
  expect_refused(ours + "x", "has 1 bytes behind its end");
  expect_refused(ours + ours, "behind its end");
  expect_refused(xz_compressed("text"), "file is not a database");
  expect_refused(xz_compressed(""), "it is empty");
  expect_refused(xz_compressed(with_trigger), "it has a trigger t that no store has");
}

/// Text with repetitions, of this length.
std::string some_text(std::size_t length) {
  std::mt19937_64 random(length);
  std::string text;
  while (text.size() < length) text += std::to_string(random() % 1000) + ",";
  text.resize(length);
  return text;
}

TEST(Xz, ReturnsWhatWasCompressedUnlessItIsDamagedCutOffOrTooLarge) {
  for (const std::size_t length : {0UL, 1UL, 65'536UL, 500'000UL}) {
    const std::string text = some_text(length);
    const std::string file = xz_compressed(text);
    EXPECT_TRUE(is_xz(file));
    EXPECT_EQ(xz_decompressed(file, length), text) << length;
    EXPECT_TRUE(length < 1000 || file.size() < length / 2);
  }
  EXPECT_FALSE(is_xz("SQLite format 3"));
  EXPECT_FALSE(is_xz(""));
  const std::string file = xz_compressed(some_text(10'000));
  std::string damaged = file;
  damaged[file.size() / 2] ^= 1;
  expect_refusals([](const std::string& bytes) { return xz_decompressed(bytes, 9'999); },
                  {{damaged, "damaged or cut off"},
                   {file.substr(0, file.size() / 2), "damaged or cut off"},
                   {"text", "damaged or cut off"},
                   {file, "more than 9999 bytes"}});
}

}  // namespace
}  // namespace ricochet
