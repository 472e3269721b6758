#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

#include "ricochet/error.h"
#include "src/experiment/merge.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/store.h"
#include "tests/support/files.h"
#include "tests/experiment/store/stored_runs.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

RunRecord a_strangers_record() {
  RunRecord record;
  record.budget.evaluations = 60;
  record.ledger = {40, 3, 0, 50, 2, 0.5};
  record.terminations = {{"done"}, {"done"}, {"spent"}};
  record.trace = {{1, 0.125, {9.5, 0.5}, Vector::Constant(2, 0.5)},
                  {20, 0.25, {3.25, 0}, Vector::Constant(2, 0.25)}};
  record.returned = {Vector::Constant(2, 0.25), {3.25, 0.0}};
  return record;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class StrangersStore : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    Store store = Store::create(file, a_description());
    for (int k = 0; k < 3; ++k) store.add(a_key(k), a_strangers_record());
  }

  void change(const std::string& sql) const {
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
  }

  /// Makes run 2 the record, with the right checksum, and with a change of the tables.
  void forge(const RunRecord& record, const std::string& sql) const {
    const auto sum =
        static_cast<std::int64_t>(checksum(a_key(1), record, repeated(record.terminations)));
    change(fmt::format("{}; UPDATE run SET checksum = {} WHERE number = 2", sql, sum));
  }

  /// Reading and adding are refused with these words, and nothing is changed.
  void expect_refused(const std::string& words, const std::string& what) const {
    const std::string before = bytes_of(file);
    for (const auto purpose : {Store::For::reading, Store::For::adding}) {
      const auto use = [&] { Store::open(file, purpose).each([](const StoredRun&) {}); };
      EXPECT_THAT(use, testing::ThrowsMessage<InputError>(HasSubstr(words))) << what;
      EXPECT_THAT(use, testing::ThrowsMessage<InputError>(HasSubstr(file.string()))) << what;
    }
    EXPECT_TRUE(bytes_of(file) == before) << what;
  }

  const fs::path file = folder_ / "runs.sqlite";
};

TEST_F(StrangersStore, HasTheSchemaOfAStoreOrIsRefused) {
  const std::string whole = bytes_of(file);
  for (const char* sql :
       {"CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM run; END",
        "CREATE TRIGGER t BEFORE INSERT ON termination BEGIN SELECT raise(ignore); END",
        "CREATE TRIGGER \"\x1b[31m\" AFTER UPDATE ON note BEGIN SELECT 1; END",
        "CREATE TABLE more (x)", "CREATE INDEX more ON run (seconds)",
        "CREATE VIEW more AS SELECT * FROM run", "CREATE VIRTUAL TABLE more USING fts5(x)"}) {
    change(sql);
    expect_refused("that no store has", sql);
    std::ofstream(file, std::ios::binary) << whole;
  }
  for (const char* sql :
       {"DROP VIEW result", "DROP VIEW result; CREATE VIEW result AS SELECT * FROM run",
        "DROP TABLE note; CREATE TABLE note (about, name, value)",
        "ALTER TABLE run ADD COLUMN more INTEGER DEFAULT (1)"}) {
    change(sql);
    expect_refused("it lacks the table or view", sql);
    std::ofstream(file, std::ios::binary) << whole;
  }
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 3);
}

TEST_F(StrangersStore, HasPossibleRunsOrIsRefusedWithTableAndRow) {
  struct Forgery {
    const char* sql;
    std::function<void(RunRecord&)> change;
    const char* words;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Forgery> forgeries = {
      {"UPDATE run SET charged = 61", [](auto& r) { r.ledger.charged = 61; },
       "table run, row 2: charged is 61: must be from 0 to 60"},
      {"UPDATE run SET charged = -1", [](auto& r) { r.ledger.charged = -1; }, "charged is -1"},
      {"UPDATE run SET refused = -9", [](auto& r) { r.ledger.refused = -9; }, "refused is -9"},
      {"UPDATE run SET seconds = -0.25", [](auto& r) { r.ledger.seconds = -0.25; },
       "seconds is -0.25: must be a time"},
      {"UPDATE run SET seconds = 9e999",
       [](auto& r) { r.ledger.seconds = std::numeric_limits<double>::infinity(); },
       "seconds is inf"},
      {"UPDATE run SET seconds = x'000000000000f87f'", [nan](auto& r) { r.ledger.seconds = nan; },
       "seconds is nan"},
      {"UPDATE run SET own_instance = -1", [](auto& r) { r.instance = -1; }, "own_instance is -1"},
      {"UPDATE run SET own_run = -4294967296", [](auto& r) { r.run = -1; },
       "own_run is -4294967296"},
      {"UPDATE improvement SET evaluations = 51 WHERE run = 2 AND step = 1",
       [](auto& r) { r.trace[1].evaluations = 51; },
       "table run, row 2: improvement 1: evaluations is 51"},
      {"UPDATE improvement SET evaluations = 30 WHERE run = 2 AND step = 0",
       [](auto& r) { r.trace[0].evaluations = 30; }, "fewer than before"},
      {"UPDATE improvement SET violation = -1.0 WHERE run = 2 AND step = 1",
       [](auto& r) { r.trace[1].true_values.violation = -1; }, "violation is -1"},
      {"UPDATE improvement SET violation = 0.75 WHERE run = 2 AND step = 1",
       [](auto& r) { r.trace[1].true_values.violation = 0.75; }, "it is no improvement"},
      {"UPDATE improvement SET objective = x'000000000000f87f' WHERE run = 2 AND step = 1",
       [nan](auto& r) { r.trace[1].true_values.objective = nan; }, "objective is not a number"},
      {"UPDATE improvement SET seconds = 0.0625 WHERE run = 2 AND step = 1",
       [](auto& r) { r.trace[1].seconds = 0.0625; }, "seconds are fewer"},
      {"UPDATE run SET returned_violation = -0.5",
       [](auto& r) { r.returned->true_values.violation = -0.5; }, "returned_violation is -0.5"},
      {"UPDATE run SET seconds_allowed = -1.0", [](auto& r) { r.budget.seconds = -1; },
       "seconds_allowed is -1"}};
  const std::string whole = bytes_of(file);
  for (const Forgery& forgery : forgeries) {
    RunRecord record = a_strangers_record();
    forgery.change(record);
    forge(record, forgery.sql);
    expect_refused(forgery.words, forgery.sql);
    EXPECT_THAT([&] { Store::create(folder_ / "new", a_description()).add(a_key(1), record); },
                testing::Throws<InputError>());
    fs::remove(folder_ / "new");
    std::ofstream(file, std::ios::binary) << whole;
  }
}

TEST_F(StrangersStore, StartsNoEndlessReading) {
  for (const std::int64_t starts : {std::int64_t{100'000'000}, std::int64_t{-1}, std::int64_t{0},
                                    std::numeric_limits<std::int64_t>::max()}) {
    const RunRecord record = a_strangers_record();
    auto terminations = repeated(record.terminations);
    terminations[0].starts = starts;
    const auto sum = static_cast<std::int64_t>(checksum(a_key(1), record, terminations));
    change(
        fmt::format("UPDATE termination SET starts = {} WHERE run = 2 AND step = 0; "
                    "UPDATE run SET checksum = {} WHERE number = 2",
                    starts, sum));
    const Store store = Store::open(file, Store::For::reading);
    EXPECT_THAT([&] { static_cast<void>(store.find(2)); },
                testing::ThrowsMessage<InputError>(HasSubstr("table run, row 2: starts")))
        << starts;
  }
}

TEST_F(StrangersStore, DescribesPossibleProblemsOrIsRefused) {
  struct Forgery {
    const char* sql;
    std::function<void(StoredProblem&)> change;
    const char* words;
  };
  const std::vector<Forgery> forgeries = {
      {"variables = -2", [](auto& p) { p.variables = -2; },
       "table problem, row 2: variables is -2"},
      {"variables = 0", [](auto& p) { p.variables = 0; }, "row 2: variables is 0"},
      {"equalities = 3", [](auto& p) { p.equalities = 3; }, "equalities is 3"},
      {"tolerance = -1.0", [](auto& p) { p.tolerance = -1; }, "tolerance is -1"},
      {"best_known = -9e999",
       [](auto& p) { p.best_known = -std::numeric_limits<double>::infinity(); },
       "best_known is -inf"}};
  const std::string whole = bytes_of(file);
  for (const Forgery& forgery : forgeries) {
    CampaignDescription description = a_description();
    forgery.change(description.problems[1]);
    change(fmt::format("UPDATE problem SET {} WHERE number = 2; UPDATE campaign SET checksum = {}",
                       forgery.sql, static_cast<std::int64_t>(checksum(description))));
    expect_refused(forgery.words, forgery.sql);
    std::ofstream(file, std::ios::binary) << whole;
  }
}

/// What SQLite would write through, or wait for, is refused before it opens anything.
TEST_F(StrangersStore, HasNothingBesideItThatIsNoFile) {
  const fs::path mine = folder_ / "mine.txt";
  std::ofstream(mine) << "mine";
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    const fs::path beside = file.string() + ending;
    fs::create_symlink(mine, beside);
    expect_refused("beside it is a link", ending);
    fs::remove(beside);
    ASSERT_EQ(mkfifo(beside.c_str(), 0600), 0);
    expect_refused("beside it is a link, folder, device or pipe", ending);
    fs::remove(beside);
    fs::create_directory(beside);
    expect_refused("beside it is a link, folder", ending);
    fs::remove(beside);
  }
  EXPECT_EQ(bytes_of(mine), "mine");
}

/// A log that is damaged anywhere but in its last frame is refused, and so is one whose changes
/// make a damaged store of a whole one; in both cases file and log stay as they are.
TEST_F(StrangersStore, IsNotChangedByADamagedLog) {
  fs::path log = file.string() + "-wal";
  std::string open_file, written;
  {
    Store writer = Store::open(file, Store::For::adding);
    for (int k = 3; k < 9; ++k) writer.add(a_key(k), a_strangers_record());
    open_file = bytes_of(file);
    written = bytes_of(log);
  }
  ASSERT_GT(written.size(), 20'000);
  const auto put = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << open_file;
    std::ofstream(log, std::ios::binary) << bytes;
  };
  for (const std::size_t place : {std::size_t{0}, std::size_t{12}, std::size_t{28}, std::size_t{60},
                                  written.size() / 3, written.size() / 2}) {
    std::string damaged = written;
    damaged[place] ^= 1;
    put(damaged);
    expect_refused("runs.sqlite-wal beside it is damaged", std::to_string(place));
    EXPECT_TRUE(bytes_of(log) == damaged) << place;
  }
  put(written);
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 9);
  EXPECT_FALSE(fs::exists(log));
}

TEST_F(StrangersStore, IsNotChangedByALogThatDamagesIt) {
  const fs::path log = file.string() + "-wal";
  std::string open_file, written;
  {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA journal_mode = WAL; UPDATE run SET seconds = 1e-9 WHERE number = 2");
    open_file = bytes_of(file);
    written = bytes_of(log);
  }
  std::ofstream(file, std::ios::binary) << open_file;
  std::ofstream(log, std::ios::binary) << written;
  expect_refused("table run, row 2: it is not what was added", "a run changed in the log");
  EXPECT_TRUE(bytes_of(log) == written);
}

}  // namespace
}  // namespace ricochet
