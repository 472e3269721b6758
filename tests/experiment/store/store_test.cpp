#include "src/experiment/store.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "tests/support/files.h"
#include "tests/experiment/store/stored_runs.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

class StoreFile : public TemporaryFolder {
 protected:
  const fs::path file = folder_ / "campaign.sqlite";

  /// A closed store of so many runs.
  std::map<RunKey, RunRecord> filled(int runs, unsigned seed = 1) const {
    std::mt19937_64 random(seed);
    std::map<RunKey, RunRecord> added;
    Store store = Store::create(file, a_description());
    for (int k = 0; k < runs; ++k) {
      const RunRecord record = any_record(random);
      store.add(a_key(k), record);
      added[a_key(k)] = record;
    }
    return added;
  }

  std::string bytes() const { return bytes_of(file); }

  static std::string bytes_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }

  /// Adds so many runs in another process, which then sends itself the signal.
  void add_and_end(int runs, int signal) const {
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      // A shell's background jobs ignore some signals, and so would this one, for ever.
      if (signal != SIGKILL) std::signal(signal, SIG_DFL);
      end_tidily_when_interrupted();
      std::mt19937_64 random(6);
      Store store = Store::open(file, Store::For::adding);
      for (int k = 0; k < runs; ++k) store.add(a_key(k), any_record(random));
      kill(getpid(), signal);
      for (;;) pause();
    }
    waitpid(writer, nullptr, 0);
  }

  /// How many files there are in the folder.
  auto files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  /// Neither way to open it does more than refuse.
  void expect_refused(const std::string& reason) const {
    for (const auto purpose : {Store::For::reading, Store::For::adding}) {
      EXPECT_THAT([&] { Store::open(file, purpose); },
                  ThrowsMessage<InputError>(AllOf(StartsWith(file.string()), HasSubstr(reason))));
    }
  }

  static std::map<RunKey, RunRecord> runs_of(const Store& store) {
    std::map<RunKey, RunRecord> runs;
    store.each([&](const StoredRun& run) { runs[run.key] = run.record; });
    return runs;
  }
};

TEST_F(StoreFile, KeepsEveryBitOfAnyRun) {
  const auto added = filled(300);
  const Store store = Store::open(file, Store::For::reading);
  EXPECT_EQ(store.description(), a_description());
  EXPECT_EQ(store.size(), 300);
  auto next = added.begin();
  store.each([&](const StoredRun& run) {
    ASSERT_NE(next, added.end());
    EXPECT_EQ(run.key, next->first) << "in the order of keys";
    expect_kept(run.record, next->second);
    const auto again = store.find(run.number);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->key, run.key);
    expect_kept(again->record, next->second);
    ++next;
  });
  EXPECT_EQ(next, added.end());
  const auto keys = store.keys();
  EXPECT_TRUE(std::equal(keys.begin(), keys.end(), added.begin(), added.end(),
                         [](const RunKey& key, const auto& run) { return key == run.first; }));
  EXPECT_FALSE(store.find(0).has_value());
  EXPECT_FALSE(store.find(301).has_value());
}

TEST_F(StoreFile, IsOneFileOnceItIsClosed) {
  filled(3);
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(caution(file), "") << "and nothing says that it lacks its log";
}

TEST_F(StoreFile, HasAllItsRunsOnceItIsFinishedThoughAnotherReadsIt) {
  Store writer = Store::create(file, a_description());
  for (int k = 0; k < 3; ++k) writer.add(a_key(k), {});
  const Store reader = Store::open(file, Store::For::reading);
  writer.finish();
  EXPECT_EQ(reader.size(), 3);
  const fs::path copy = folder_ / "copy.sqlite";
  fs::copy(file, copy);
  EXPECT_EQ(Store::open(copy, Store::For::reading).size(), 3);
}

TEST_F(StoreFile, IsNotDraftedIntoWhatAnotherHasPutThere) {
  const fs::path other = folder_ / "other.txt";
  std::ofstream(other) << "another's\n";
  for (int number = 0; number < 200; ++number) {  // the names that drafts get
    fs::create_symlink(other,
                       folder_ / fmt::format(".ricochet.{}.{}.store.part", getpid(), number));
  }
  { const Store store = Store::create(file, a_description()); }
  EXPECT_EQ(fs::file_size(other), 10);
  EXPECT_FALSE(fs::is_symlink(file));
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 0);
}

TEST_F(StoreFile, IsOneFileAfterAnInterruption) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    fs::remove(file);
    Store::create(file, a_description());
    add_and_end(30, signal);
    EXPECT_EQ(files(), 1) << signal;
    EXPECT_EQ(caution(file), "");
    EXPECT_EQ(Store::open(file, Store::For::reading).size(), 30);
  }
}

TEST_F(StoreFile, IsOneFileAfterItIsReadIfItsWriterWasKilled) {
  Store::create(file, a_description());
  add_and_end(30, SIGKILL);
  EXPECT_GT(files(), 1);
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 30);
  EXPECT_EQ(files(), 1);
}

TEST_F(StoreFile, CanOnlyBeReadOnceItIsFinished) {
  Store store = Store::create(file, a_description());
  store.add(a_key(0), {});
  store.finish();
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(store.size(), 1);
  EXPECT_THROW(store.add(a_key(1), {}), OutputError);
  EXPECT_NO_THROW(Store::open(file, Store::For::adding));
}

TEST_F(StoreFile, SaysThatRunsMayBeMissingInACopyOfItAlone) {
  Store::create(file, a_description());
  add_and_end(30, SIGKILL);
  const fs::path copies = folder_ / "copies";
  fs::create_directory(copies);
  const fs::path copy = copies / file.filename();
  fs::copy(file, copy);
  for (int k = 0; k < 2; ++k) {
    EXPECT_LT(Store::open(copy, Store::For::reading).size(), 30);
    EXPECT_THAT(caution(copy), HasSubstr("runs may be missing"));
    EXPECT_EQ(std::distance(fs::directory_iterator(copies), fs::directory_iterator()), 1);
  }
  fs::copy(file.string() + "-wal", copy.string() + "-wal");
  EXPECT_EQ(Store::open(copy, Store::For::reading).size(), 30);
  EXPECT_EQ(caution(copy), "");
}

TEST_F(StoreFile, SaysThatRunsAreBeingAdded) {
  const Store writer = Store::create(file, a_description());
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 0);
  EXPECT_THAT(caution(file), HasSubstr("another ricochet is adding runs"));
}

TEST_F(StoreFile, HasAnyName) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  for (const char* name : {":memory:", "file:x?mode=memory"}) {
    {
      Store store = Store::create(name, a_description());
      store.add(a_key(0), {});
    }
    EXPECT_EQ(Store::open(folder_ / name, Store::For::reading).size(), 1) << name;
    EXPECT_EQ(Store::open(name, Store::For::reading).size(), 1) << name;
  }
  fs::current_path(before);
}

TEST_F(StoreFile, TakesMoreRunsLater) {
  const auto added = filled(3);
  {
    Store store = Store::open(file, Store::For::adding);
    EXPECT_EQ(store.size(), 3);
    store.add(a_key(3), {});
    EXPECT_THAT([&] { store.add(a_key(1), {}); },
                ThrowsMessage<InputError>(HasSubstr("is there already")));
    RunKey stranger = a_key(4);
    stranger.cell.problem = "unheard";
    EXPECT_THROW(store.add(stranger, {}), InputError);
    stranger = a_key(4);
    stranger.cell.solver = "unheard";
    EXPECT_THROW(store.add(stranger, {}), InputError);
    RunRecord another_reason;  // taken back with the run that is there already
    another_reason.terminations = {{"never heard"}};
    EXPECT_THROW(store.add(a_key(1), another_reason), InputError);
    store.add(a_key(4), another_reason);
  }
  const Store store = Store::open(file, Store::For::reading);
  EXPECT_EQ(store.size(), 5);
  expect_kept(runs_of(store).at(a_key(1)), added.at(a_key(1)));
  EXPECT_EQ(runs_of(store).at(a_key(4)).terminations.at(0).reason, "never heard");
}

TEST_F(StoreFile, IsNeverMadeOverAnother) {
  write("mine");
  EXPECT_THROW(Store::create(file, a_description()), InputError);
  EXPECT_EQ(bytes(), "mine");
  EXPECT_THROW(Store::create(folder_ / "missing" / "file", a_description()), InputError);
  EXPECT_THROW(Store::create("/dev/null", a_description()), InputError);
  CampaignDescription twice = a_description();
  twice.solvers.push_back(twice.solvers[0]);
  EXPECT_THROW(Store::create(folder_ / "new", twice), InputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "nothing is left";
  fs::rename(file, file.string() + "-wal");  // as of a killed store that was removed
  EXPECT_THAT([&] { Store::create(file, a_description()); },
              ThrowsMessage<InputError>(HasSubstr("is left of another")));
}

TEST_F(StoreFile, IsWrittenByOneWhileOthersRead) {
  Store store = Store::create(file, a_description());
  EXPECT_THAT([&] { Store::open(file, Store::For::adding); },
              ThrowsMessage<InputError>(HasSubstr("another ricochet adds runs")));
  const Store reader = Store::open(file, Store::For::reading);
  for (int k = 0; k < 5; ++k) {
    store.add(a_key(k), {});
    EXPECT_EQ(reader.size(), k + 1);
    EXPECT_EQ(Store::open(file, Store::For::reading).size(), k + 1);
  }
  { const Store closed = std::move(store); }
  EXPECT_EQ(reader.size(), 5);
  EXPECT_NO_THROW(Store::open(file, Store::For::adding));
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 5);
}

TEST_F(StoreFile, SaysWhenTheDiskIsFull) {
  filled(1);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  {
    Store store = Store::open(file, Store::For::adding);
    const rlimit small = {60'000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto record = [](int number) {  // of which one table more has something new
      RunRecord made;
      made.terminations = {{"the reason " + std::to_string(number)}};
      return made;
    };
    int added = 1;
    EXPECT_THROW(for (; added < 1000; ++added) store.add(a_key(added), record(added)), OutputError);
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(store.size(), added);
    store.add(a_key(added), record(added));
    EXPECT_EQ(store.size(), added + 1) << "goes on when there is room again";
  }
  EXPECT_NO_THROW(Store::open(file, Store::For::reading));
}

TEST_F(StoreFile, IsNotBegunWhereNoMoreFilesMayBeOpen) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const int next = dup(STDERR_FILENO);
  ::close(next);
  const rlimit all_taken = {static_cast<rlim_t>(next), before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &all_taken);
  EXPECT_THAT([&] { Store::create(file, a_description()); },
              ThrowsMessage<OutputError>(HasSubstr("cannot be made: Too many open files")));
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(StoreFile, OfAnotherKindIsRefusedUntouched) {
  expect_refused("No such file");
  write("");
  expect_refused("empty");
  write("plan = \"campaign\"\n");
  expect_refused("not a database");
  EXPECT_EQ(bytes(), "plan = \"campaign\"\n");
  write("SQLite format 3");
  expect_refused("not a database");
  fs::remove(file);
  fs::create_directory(file);
  expect_refused("no file, but a folder");
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  expect_refused("pipe");
  EXPECT_THROW(Store::open("/dev/null", Store::For::reading), InputError);
  EXPECT_THROW(Store::open("/dev/zero", Store::For::adding), InputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "nothing is made beside it";
}

TEST_F(StoreFile, OfAnotherProgramOrVersionIsRefusedUntouched) {
  filled(1);
  const std::string whole = bytes();
  // Offsets as in https://www.sqlite.org/fileformat2.html, 1.3.
  for (const auto& [offset, reason] :
       {std::pair(68, std::string("another program made it")),
        std::pair(60, fmt::format("made by version {} of the suite, this is version {}",
                                  0x0A000000 + suite_version, suite_version))}) {
    std::string changed = whole;
    changed[static_cast<std::size_t>(offset)] = 10;
    write(changed);
    expect_refused(reason);
    EXPECT_EQ(bytes(), changed);
  }
  std::string renamed = whole;
  renamed.replace(renamed.find("termination_reason"), 7, "REFUSAL");
  write(renamed);
  expect_refused("");
  EXPECT_EQ(bytes(), renamed);
}

TEST_F(StoreFile, OfVersion1OfTheSuiteIsRefusedInALineThatSaysSo) {
  filled(1);
  std::string old = bytes();
  old[63] = 1;  // the user_version
  write(old);
  EXPECT_THAT(
      [&] { Store::open(file, Store::For::reading); },
      ThrowsMessage<InputError>(file.string() + ": cannot be opened as a campaign: made by version "
                                                "1 of the suite, this is version 3; run "
                                                "the plan again, or use ricochet 0.1"));
}

/// What a store tells, or that it refuses.
std::optional<std::string> told(const fs::path& file) {
  try {
    const Store store = Store::open(file, Store::For::reading);
    return store.digest() + std::to_string(store.keys().size());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TEST_F(StoreFile, ThatIsDamagedTellsTheTrueValuesOrNothing) {
  filled(20);
  const std::string whole = bytes();
  const auto true_values = told(file);
  ASSERT_TRUE(true_values.has_value());
  std::mt19937_64 random(3);
  int refused = 0;
  for (int k = 0; k < 500; ++k) {
    std::string damaged = whole;
    if (k % 5 == 0) damaged.resize(random() % whole.size());
    for (auto flips = k % 5 == 0 ? 0 : 1 + random() % 3; flips > 0; --flips) {
      const auto range = random() % 8 == 0 ? 100 : damaged.size();  // often in the header
      damaged[random() % range] ^= static_cast<char>(1 << random() % 8);
    }
    write(damaged);
    const auto answer = told(file);
    if (!answer) ++refused;
    EXPECT_TRUE(!answer || answer == true_values) << k;
    if (k % 10 == 0) {
      try {
        Store::open(file, Store::For::adding);
      } catch (const InputError&) {
        EXPECT_EQ(bytes(), damaged);
      }
    } else {
      ASSERT_EQ(bytes(), damaged) << k;
    }
    for (const char* beside : {"-wal", "-shm", "-journal", "-lock"}) {
      fs::remove(file.string() + beside);
    }
  }
  EXPECT_GT(refused, 150);
}

TEST_F(StoreFile, HasAllRunsThatWereAddedBeforeItsWriterWasKilled) {
  Store::create(file, a_description());
  std::mt19937_64 random(4);
  int there = 0;
  for (int killed = 0; killed < 40; ++killed) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      std::mt19937_64 any(5);
      for (;;) {  // opened, filled and closed again and again
        Store store = Store::open(file, Store::For::adding);
        for (int k = 0; k < 20; ++k, ++there) {
          store.add(a_key(there), any_record(any));
          if (::write(ends[1], "+", 1) != 1) _exit(1);
        }
      }
    }
    ::close(ends[1]);
    pollfd first{ends[0], POLLIN, 0};
    if (killed % 2 == 0) poll(&first, 1, 10'000);  // else before it has added any, maybe
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40'000));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    char told[1 << 16];
    int acknowledged = there;
    for (ssize_t got = 0; (got = read(ends[0], told, sizeof told)) > 0;) {
      acknowledged += static_cast<int>(got);
    }
    ::close(ends[0]);
    const Store store = Store::open(file, Store::For::reading);
    const auto keys = store.keys();
    there = static_cast<int>(keys.size());
    ASSERT_GE(there, acknowledged);
    ASSERT_LE(there, acknowledged + 1) << "at most the run in flight";
    for (int k = 0; k < there; ++k) ASSERT_TRUE(keys.contains(a_key(k)));
    ASSERT_EQ(runs_of(store).size(), keys.size()) << "all can be read";
  }
  EXPECT_GT(there, 0);
}

// The first page, which tells the size of all, is moved from the log to the file before the rest.
TEST_F(StoreFile, IsReadWhereItsWriterWasKilledAsItMovedTheFirstPage) {
  Store::create(file, a_description());
  const pid_t writer = fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    std::mt19937_64 random(6);
    Store store = Store::open(file, Store::For::adding);
    for (int k = 0; k < 100; ++k) store.add(a_key(k), any_record(random));
    raise(SIGKILL);
  }
  waitpid(writer, nullptr, 0);
  std::string moved = bytes();
  constexpr std::size_t pages = 28;  // https://www.sqlite.org/fileformat2.html, 1.3
  ASSERT_EQ(moved[pages], 0);
  moved[pages + 2] = 1;
  write(moved);
  EXPECT_EQ(Store::open(file, Store::For::reading).keys().size(), 100U);
}

TEST_F(StoreFile, IsReadWhereNothingCanBeWritten) {
  filled(4);
  const auto expect_readable = [&] {
    constexpr mode_t read_only = 0555;
    ASSERT_EQ(chmod(folder_.c_str(), read_only), 0);
    const bool root = geteuid() == 0;  // who may write everywhere
    constexpr uid_t nobody = 65534;
    if (root) {
      ASSERT_EQ(seteuid(nobody), 0);
    }
    EXPECT_NO_THROW(EXPECT_EQ(Store::open(file, Store::For::reading).size(), 4));
    EXPECT_THROW(Store::open(file, Store::For::adding), InputError);
    if (root) {
      ASSERT_EQ(seteuid(0), 0);
    }
    fs::permissions(folder_, fs::perms::owner_all);
  };
  expect_readable();
  {  // a reader keeps it from being closed wholly
    auto writer = std::make_unique<Store>(Store::open(file, Store::For::adding));
    const Store reader = Store::open(file, Store::For::reading);
    writer.reset();
  }
  expect_readable();
}

TEST_F(StoreFile, HasADigestOfAllButTimesAndPlaces) {
  std::mt19937_64 random(6);
  std::vector<RunRecord> records;
  for (int k = 0; k < 30; ++k) records.push_back(any_record(random));
  std::vector<int> order(records.size());
  std::iota(order.begin(), order.end(), 0);
  const auto digest = [&](const CampaignDescription& description) {
    fs::remove(file);
    Store store = Store::create(file, description);
    for (const int k : order) store.add(a_key(k), records[static_cast<std::size_t>(k)]);
    return store.digest();
  };
  const std::string first = digest(a_description());
  EXPECT_EQ(first.size(), 16U);
  std::shuffle(order.begin(), order.end(), random);
  for (RunRecord& record : records) {
    record.ledger.seconds = 7;
    for (Improvement& step : record.trace) step.seconds = 8;
  }
  CampaignDescription elsewhere = a_description();
  elsewhere.made["date"] = "2027-01-01";
  EXPECT_EQ(digest(elsewhere), first);
  records[5].seed ^= 1;
  EXPECT_NE(digest(a_description()), first);
  records[5].seed ^= 1;
  elsewhere.plan += "\n";
  EXPECT_NE(digest(elsewhere), first);
}

}  // namespace
}  // namespace ricochet
