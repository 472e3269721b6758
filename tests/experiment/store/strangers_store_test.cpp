#include <SQLiteCpp/Database.h>
#include <sys/stat.h>

#include "src/experiment/merge.h"
#include "src/experiment/run_rows.h"
#include "tests/experiment/store/stored.h"

namespace ricochet {
namespace {

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

class StrangersStore : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    {
      Store store = Store::create(file, a_description());
      add(store, std::vector<RunRecord>(3, a_strangers_record()));
    }
    whole = text_of(file);
  }

  void change(const std::string& sql) const {
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
  }

  /// Reading and adding are refused with these words, and nothing is changed.
  void expect_refused(const std::string& words, const std::string& what) const {
    SCOPED_TRACE(what);
    const std::string before = text_of(file);
    expect_no_store(file, words);
    EXPECT_TRUE(text_of(file) == before);
  }

  /// The same of the whole store after a change of its tables.
  void expect_refused_after(const std::string& sql, const std::string& words) const {
    change(sql);
    expect_refused(words, sql);
    write_file(file, whole);
  }

  const fs::path file = folder_ / "runs.sqlite";
  std::string whole;
};

TEST_F(StrangersStore, HasTheSchemaOfAStoreOrIsRefused) {
  for (const char* sql :
       {"CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM run; END",
        "CREATE TRIGGER t BEFORE INSERT ON termination BEGIN SELECT raise(ignore); END",
        "CREATE TRIGGER \"\x1b[31m\" AFTER UPDATE ON note BEGIN SELECT 1; END",
        "CREATE TABLE more (x)", "CREATE INDEX more ON run (seconds)",
        "CREATE VIEW more AS SELECT * FROM run", "CREATE VIRTUAL TABLE more USING fts5(x)"}) {
    expect_refused_after(sql, "that no store has");
  }
  for (const char* sql :
       {"DROP VIEW result", "DROP VIEW result; CREATE VIEW result AS SELECT * FROM run",
        "DROP TABLE note; CREATE TABLE note (about, name, value)",
        "ALTER TABLE run ADD COLUMN more INTEGER DEFAULT (1)"}) {
    expect_refused_after(sql, "it lacks the table or view");
  }
  EXPECT_EQ(reading(file).size(), 3);
}

/// Of a forgery the columns that a stranger has changed, with the right checksum of the record.
template <class Record>
struct Forgery {
  std::string columns;
  std::function<void(Record&)> change;
  std::string words;
};

TEST_F(StrangersStore, HasPossibleRunsOrIsRefusedWithTableAndRow) {
  const std::string step_0 = " WHERE run = 2 AND step = 0", step_1 = " WHERE run = 2 AND step = 1";
  const std::vector<Forgery<RunRecord>> forgeries = {
      {"run SET charged = 61", [](auto& r) { r.ledger.charged = 61; },
       "table run, row 2: charged is 61: must be from 0 to 60"},
      {"run SET charged = -1", [](auto& r) { r.ledger.charged = -1; }, "charged is -1"},
      {"run SET refused = -9", [](auto& r) { r.ledger.refused = -9; }, "refused is -9"},
      {"run SET seconds = -0.25", [](auto& r) { r.ledger.seconds = -0.25; },
       "seconds is -0.25: must be a time"},
      {"run SET seconds = 9e999", [](auto& r) { r.ledger.seconds = infinity; }, "seconds is inf"},
      {"run SET seconds = x'000000000000f87f'", [](auto& r) { r.ledger.seconds = quiet_nan; },
       "seconds is nan"},
      {"run SET own_instance = -1", [](auto& r) { r.instance = -1; }, "own_instance is -1"},
      {"run SET own_run = -4294967296", [](auto& r) { r.run = -1; }, "own_run is -4294967296"},
      {"run SET returned_violation = -0.5",
       [](auto& r) { r.returned->true_values.violation = -0.5; }, "returned_violation is -0.5"},
      {"run SET seconds_allowed = -1.0", [](auto& r) { r.budget.seconds = -1; },
       "seconds_allowed is -1"},
      {"improvement SET evaluations = 30" + step_0, [](auto& r) { r.trace[0].evaluations = 30; },
       "fewer than before"},
      {"improvement SET evaluations = 51" + step_1, [](auto& r) { r.trace[1].evaluations = 51; },
       "table run, row 2: improvement 1: evaluations is 51"},
      {"improvement SET violation = -1.0" + step_1,
       [](auto& r) { r.trace[1].true_values.violation = -1; }, "violation is -1"},
      {"improvement SET violation = 0.75" + step_1,
       [](auto& r) { r.trace[1].true_values.violation = 0.75; }, "it is no improvement"},
      {"improvement SET objective = x'000000000000f87f'" + step_1,
       [](auto& r) { r.trace[1].true_values.objective = quiet_nan; }, "objective is not a number"},
      {"improvement SET seconds = 0.0625" + step_1, [](auto& r) { r.trace[1].seconds = 0.0625; },
       "seconds are fewer"}};
  for (const auto& [update, change, words] : forgeries) {
    RunRecord record = a_strangers_record();
    change(record);
    const std::uint64_t sum = checksum(a_key(1), record, repeated(record.terminations));
    expect_refused_after(fmt::format("UPDATE {}; UPDATE run SET checksum = {} WHERE number = 2",
                                     update, static_cast<std::int64_t>(sum)),
                         words);
    EXPECT_THROW(Store::create(folder_ / "new", a_description()).add(a_key(1), record), InputError);
    fs::remove(folder_ / "new");
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
    const Store store = reading(file);
    EXPECT_THAT(complaint_of([&] { return store.find(2); }), HasSubstr("table run, row 2: starts"))
        << starts;
  }
}

TEST_F(StrangersStore, DescribesPossibleProblemsOrIsRefused) {
  const std::vector<Forgery<StoredProblem>> forgeries = {
      {"variables = -2", [](auto& p) { p.variables = -2; },
       "table problem, row 2: variables is -2"},
      {"variables = 0", [](auto& p) { p.variables = 0; }, "row 2: variables is 0"},
      {"equalities = 3", [](auto& p) { p.equalities = 3; }, "equalities is 3"},
      {"tolerance = -1.0", [](auto& p) { p.tolerance = -1; }, "tolerance is -1"},
      {"best_known = -9e999", [](auto& p) { p.best_known = -infinity; }, "best_known is -inf"}};
  for (const auto& [columns, change, words] : forgeries) {
    CampaignDescription description = a_description();
    change(description.problems[1]);
    expect_refused_after(
        fmt::format("UPDATE problem SET {} WHERE number = 2; UPDATE campaign SET checksum = {}",
                    columns, static_cast<std::int64_t>(checksum(description))),
        words);
  }
}

/// What SQLite would write through, or wait for, is refused before it opens anything.
TEST_F(StrangersStore, HasNothingBesideItThatIsNoFile) {
  const fs::path mine = write_file(folder_ / "mine.txt", "mine");
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
  EXPECT_EQ(text_of(mine), "mine");
}

/// A log that is damaged anywhere but in its last frame is refused, and so is one whose changes
/// make a damaged store of a whole one; in both cases file and log stay as they are.
TEST_F(StrangersStore, IsNotChangedByALogThatIsDamagedOrDamagesIt) {
  const fs::path log = file.string() + "-wal";
  std::string open, written;  // the store and its log while it is open
  const auto expect_log_refused = [&](const std::string& bytes, const std::string& words) {
    write_file(file, open);
    write_file(log, bytes);
    expect_refused(words, "a log");
    EXPECT_TRUE(text_of(log) == bytes);
  };
  {
    Store writer = adding(file);
    add(writer, std::vector<RunRecord>(6, a_strangers_record()), 3);
    open = text_of(file), written = text_of(log);
  }
  const std::size_t size = written.size();
  ASSERT_GT(size, 20'000);
  for (const std::size_t place : {0UL, 12UL, 28UL, 60UL, size / 3, size / 2}) {
    SCOPED_TRACE(place);
    std::string damaged = written;
    damaged[place] ^= 1;
    expect_log_refused(damaged, "runs.sqlite-wal beside it is damaged");
  }
  write_file(log, written);
  EXPECT_EQ(reading(file).size(), 9);
  EXPECT_FALSE(fs::exists(log));
  {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA journal_mode = WAL; UPDATE run SET seconds = 1e-9 WHERE number = 2");
    open = text_of(file), written = text_of(log);
  }
  expect_log_refused(written, "table run, row 2: it is not what was added");
}

}  // namespace
}  // namespace ricochet
