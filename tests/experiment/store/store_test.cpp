#include "src/experiment/store.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/experiment/run_rows.h"
#include "tests/experiment/store/stored.h"
#include "tests/support/pipe.h"

namespace ricochet {
namespace {

class StoreFile : public TemporaryFolder {
 protected:
  const fs::path file = folder_ / "campaign.sqlite";

  Store created() const { return Store::create(file, a_description()); }

  /// A closed store of so many runs.
  std::vector<RunRecord> filled(int runs) const {
    const std::vector<RunRecord> records = any_records(runs, 1);
    Store store = created();
    add(store, records);
    return records;
  }

  void expect_refused_untouched(const std::string& bytes, const std::string& words) const {
    write_file(file, bytes);
    expect_no_store(file, words);
    EXPECT_EQ(text_of(file), bytes);
  }

  /// Adds so many runs in another process, which then sends itself the signal.
  void add_and_end(int runs, int signal) const {
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      // A shell's background jobs ignore some signals, and so would this one, for ever.
      if (signal != SIGKILL) std::signal(signal, SIG_DFL);
      end_tidily_when_interrupted();
      Store store = adding(file);
      add(store, any_records(runs, 6));
      kill(getpid(), signal);
      for (;;) pause();
    }
    waitpid(writer, nullptr, 0);
  }
};

TEST_F(StoreFile, KeepsEveryBitOfAnyRun) {
  std::map<RunKey, std::vector<std::string>> added;
  for (int k = 0; const RunRecord& record : filled(300))
    added[a_key(k++)] = bits_of(kept_of(record));
  const Store store = reading(file);
  EXPECT_EQ(store.description(), a_description());
  EXPECT_EQ(store.size(), 300);
  EXPECT_EQ(bits_of(store), added);
  std::vector<RunKey> order;
  store.each([&](const StoredRun& run) {
    order.push_back(run.key);
    for (const auto& again : {store.find(run.number), store.find(run.key)}) {
      EXPECT_EQ(again.value().key, run.key);
      EXPECT_EQ(bits_of(again.value().record), bits_of(run.record));
    }
  });
  const std::set<RunKey> keys = store.keys();
  EXPECT_EQ(order, std::vector<RunKey>(keys.begin(), keys.end())) << "in the order of keys";
  EXPECT_FALSE(store.find(0) || store.find(301) || store.find(a_key(300)));
}

TEST_F(StoreFile, IsWholeAndCanOnlyBeReadOnceItIsFinishedThoughAnotherReadsIt) {
  Store writer = created();
  add(writer, std::vector<RunRecord>(3));
  {
    const Store reader = reading(file);
    writer.finish();
    EXPECT_EQ(reader.size(), 3);
    const fs::path copy = folder_ / "copy.sqlite";
    fs::copy(file, copy);
    EXPECT_EQ(reading(copy).size(), 3);
  }
  EXPECT_EQ(writer.size(), 3);
  EXPECT_THROW(writer.add(a_key(3), {}), OutputError);
  EXPECT_NO_THROW(adding(file));
}

TEST_F(StoreFile, IsNotDraftedIntoWhatAnotherHasPutThere) {
  const fs::path other = write_file(folder_ / "other.txt", "another's\n");
  for (int number = 0; number < 200; ++number) {  // the names that drafts get
    fs::create_symlink(other,
                       folder_ / fmt::format(".ricochet.{}.{}.store.part", getpid(), number));
  }
  created();
  EXPECT_EQ(fs::file_size(other), 10);
  EXPECT_FALSE(fs::is_symlink(file));
  EXPECT_EQ(reading(file).size(), 0);
}

TEST_F(StoreFile, IsOneFileOnceItIsClosedAndAfterAnInterruption) {
  for (const int signal : {0, SIGINT, SIGTERM, SIGHUP}) {
    fs::remove(file);
    filled(signal == 0 ? 30 : 0);
    if (signal != 0) add_and_end(30, signal);
    EXPECT_EQ(number_of_files(folder_), 1) << signal;
    EXPECT_EQ(caution(file), "") << "and nothing says that it lacks its log";
    EXPECT_EQ(reading(file).size(), 30);
  }
}

TEST_F(StoreFile, IsOneFileAfterItIsReadIfItsWriterWasKilledUnlessItsLogIsLeftBehind) {
  created();
  add_and_end(30, SIGKILL);
  const fs::path copy = folder_ / "copies" / file.filename();
  fs::create_directory(copy.parent_path());
  fs::copy(file, copy);
  for (int k = 0; k < 2; ++k) {
    EXPECT_LT(reading(copy).size(), 30);
    EXPECT_THAT(caution(copy), HasSubstr("runs may be missing"));
    EXPECT_EQ(number_of_files(copy.parent_path()), 1);
  }
  fs::copy(file.string() + "-wal", copy.string() + "-wal");
  for (const fs::path& whole : {copy, file}) {
    EXPECT_EQ(reading(whole).size(), 30);
    EXPECT_EQ(caution(whole), "");
  }
  EXPECT_EQ(number_of_files(folder_), 2) << "the file and the folder of copies";
}

TEST_F(StoreFile, HasAnyName) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  for (const char* name : {":memory:", "file:x?mode=memory"}) {
    Store::create(name, a_description()).add(a_key(0), {});
    EXPECT_EQ(reading(folder_ / name).size(), 1) << name;
    EXPECT_EQ(reading(name).size(), 1) << name;
  }
  fs::current_path(before);
}

TEST_F(StoreFile, TakesMoreRunsLater) {
  const std::vector<RunRecord> records = filled(3);
  RunRecord another_reason;  // taken back with the run that is there already
  another_reason.terminations = {{"never heard"}};
  {
    Store store = adding(file);
    EXPECT_EQ(store.size(), 3);
    store.add(a_key(3), {});
    EXPECT_THAT(complaint_of([&] { return store.add(a_key(1), another_reason), 0; }),
                HasSubstr("is there already"));
    for (const auto unheard : {&Cell::problem, &Cell::solver}) {
      RunKey stranger = a_key(4);
      stranger.cell.*unheard = "unheard";
      EXPECT_THROW(store.add(stranger, {}), InputError);
    }
    store.add(a_key(4), another_reason);
  }
  const auto all = bits_of(reading(file));
  EXPECT_EQ(all.size(), 5U);
  EXPECT_EQ(all.at(a_key(1)), bits_of(kept_of(records[1])));
  EXPECT_EQ(all.at(a_key(4)), bits_of(another_reason));
}

TEST_F(StoreFile, IsNeverMadeOverAnother) {
  write_file(file, "mine");
  EXPECT_THROW(created(), InputError);
  EXPECT_EQ(text_of(file), "mine");
  EXPECT_THROW(Store::create(folder_ / "missing" / "file", a_description()), InputError);
  EXPECT_THROW(Store::create("/dev/null", a_description()), InputError);
  CampaignDescription twice = a_description();
  twice.solvers.push_back(twice.solvers[0]);
  EXPECT_THROW(Store::create(folder_ / "new", twice), InputError);
  EXPECT_EQ(number_of_files(folder_), 1) << "nothing is left";
  fs::rename(file, file.string() + "-wal");  // as of a killed store that was removed
  EXPECT_THAT(complaint_of([&] { return created(); }), HasSubstr("is left of another"));
}

TEST_F(StoreFile, IsWrittenByOneWhileOthersRead) {
  Store store = created();
  EXPECT_EQ(reading(file).size(), 0);
  EXPECT_THAT(caution(file), HasSubstr("another ricochet is adding runs"));
  EXPECT_THAT(complaint_of([&] { return adding(file); }), HasSubstr("another ricochet adds runs"));
  const Store reader = reading(file);
  for (int k = 0; k < 5; ++k) {
    store.add(a_key(k), {});
    EXPECT_EQ(reader.size(), k + 1);
    EXPECT_EQ(reading(file).size(), k + 1);
  }
  { const Store closed = std::move(store); }
  EXPECT_EQ(reader.size(), 5);
  EXPECT_NO_THROW(adding(file));
  EXPECT_EQ(reading(file).size(), 5);
}

/// Sets a limit of this process, and returns what it was.
template <class Resource>
rlimit limited_to(Resource resource, rlim_t most) {
  rlimit before{};
  getrlimit(resource, &before);
  const rlimit limit = {most, before.rlim_max};
  setrlimit(resource, &limit);
  return before;
}

TEST_F(StoreFile, SaysWhenTheDiskIsFull) {
  filled(1);
  std::signal(SIGXFSZ, SIG_IGN);
  {
    Store store = adding(file);
    const rlimit before = limited_to(RLIMIT_FSIZE, 60'000);
    int added = 1;
    const auto add_next = [&] {
      RunRecord record;  // of which one table more has something new
      record.terminations = {{"the reason " + std::to_string(added)}};
      store.add(a_key(added), record);
    };
    EXPECT_THROW(for (; added < 1000; ++added) add_next(), OutputError);
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(store.size(), added);
    add_next();
    EXPECT_EQ(store.size(), added + 1) << "goes on when there is room again";
  }
  EXPECT_NO_THROW(reading(file));
}

TEST_F(StoreFile, IsNotBegunWhereNoMoreFilesMayBeOpen) {
  const int next = dup(STDERR_FILENO);
  ::close(next);
  const rlimit before = limited_to(RLIMIT_NOFILE, static_cast<rlim_t>(next));
  EXPECT_THAT(complaint_of<OutputError>([&] { return created(); }),
              HasSubstr("cannot be made: Too many open files"));
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(StoreFile, OfAnotherKindIsRefusedUntouched) {
  expect_no_store(file, "No such file");
  expect_refused_untouched("", "empty");
  expect_refused_untouched("plan = \"campaign\"\n", "not a database");
  expect_refused_untouched("SQLite format 3", "not a database");
  fs::remove(file);
  fs::create_directory(file);
  expect_no_store(file, "no file, but a folder");
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  expect_no_store(file, "pipe");
  EXPECT_THROW(reading("/dev/null"), InputError);
  EXPECT_THROW(adding("/dev/zero"), InputError);
  EXPECT_EQ(number_of_files(folder_), 1) << "nothing is made beside it";
}

TEST_F(StoreFile, OfAnotherProgramOrVersionIsRefusedUntouched) {
  filled(1);
  std::string whole = text_of(file);
  const auto expect_refused_with = [&](std::size_t offset, char byte, const std::string& words) {
    std::string changed = whole;
    changed[offset] = byte;
    expect_refused_untouched(changed, words);
  };
  const auto of_version = [](int version) {
    return fmt::format(
        "cannot be opened as a campaign: made by version {} of the suite, this is version {}",
        version, suite_version);
  };
  // Offsets as in https://www.sqlite.org/fileformat2.html, 1.3; the suite's version is at 60 to 63.
  expect_refused_with(68, 10, "another program made it");
  expect_refused_with(60, 10, of_version(0x0A000000 + suite_version));
  expect_refused_with(63, 1, of_version(1) + "; run the plan again, or use ricochet 0.1");
  expect_refused_untouched(whole.replace(whole.find("termination_reason"), 7, "REFUSAL"), "");
}

/// What a store tells; nothing where it is refused.
std::string told(const fs::path& file) {
  try {
    const Store store = reading(file);
    return store.digest() + std::to_string(store.keys().size());
  } catch (const InputError&) {
    return "";
  }
}

TEST_F(StoreFile, ThatIsDamagedTellsTheTrueValuesOrNothing) {
  filled(20);
  const std::string whole = text_of(file);
  const std::string true_values = told(file);
  ASSERT_FALSE(true_values.empty());
  std::mt19937_64 random(3);
  int refused = 0;
  for (int k = 0; k < 500; ++k) {
    std::string damaged = whole;
    if (k % 5 == 0) damaged.resize(random() % whole.size());
    for (auto flips = k % 5 == 0 ? 0 : 1 + random() % 3; flips > 0; --flips) {
      const auto range = random() % 8 == 0 ? 100 : damaged.size();  // often in the header
      damaged[random() % range] ^= static_cast<char>(1 << random() % 8);
    }
    write_file(file, damaged);
    const std::string answer = told(file);
    if (answer.empty()) ++refused;
    EXPECT_TRUE(answer.empty() || answer == true_values) << k;
    const bool opened = k % 10 == 0 && complaint_of([&] { return adding(file); }) == "accepted";
    ASSERT_TRUE(opened || text_of(file) == damaged) << k;
    for (const char* end : {"-wal", "-shm", "-journal", "-lock"}) fs::remove(file.string() + end);
  }
  EXPECT_GT(refused, 150);
}

TEST_F(StoreFile, HasAllRunsThatWereAddedBeforeItsWriterWasKilled) {
  created();
  std::mt19937_64 random(4);
  int there = 0;
  for (int killed = 0; killed < 40; ++killed) {
    Pipe pipe;
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      std::mt19937_64 any(5);
      for (;;) {  // opened, filled and closed again and again
        Store store = adding(file);
        for (int k = 0; k < 20; ++k, ++there) {
          store.add(a_key(there), any::record(any));
          if (::write(pipe.write_end(), "+", 1) != 1) _exit(1);
        }
      }
    }
    pipe.stop_writing();
    pollfd first{pipe.read_end(), POLLIN, 0};
    if (killed % 2 == 0) poll(&first, 1, 10'000);  // else before it has added any, maybe
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40'000));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    const int acknowledged = there + static_cast<int>(pipe.rest().size());
    const auto all = bits_of(reading(file));
    there = static_cast<int>(all.size());
    ASSERT_GE(there, acknowledged);
    ASSERT_LE(there, acknowledged + 1) << "at most the run in flight";
    for (int k = 0; k < there; ++k) ASSERT_TRUE(all.contains(a_key(k)));
  }
  EXPECT_GT(there, 0);
}

// The first page, which tells the size of all, is moved from the log to the file before the rest.
TEST_F(StoreFile, IsReadWhereItsWriterWasKilledAsItMovedTheFirstPage) {
  created();
  add_and_end(100, SIGKILL);
  std::string moved = text_of(file);
  constexpr std::size_t pages = 28;  // https://www.sqlite.org/fileformat2.html, 1.3
  ASSERT_EQ(moved[pages], 0);
  moved[pages + 2] = 1;
  write_file(file, moved);
  EXPECT_EQ(reading(file).keys().size(), 100U);
}

TEST_F(StoreFile, IsReadWhereNothingCanBeWritten) {
  filled(4);
  const auto expect_readable = [&] {
    fs::permissions(folder_, fs::perms{0555});
    const bool root = geteuid() == 0;  // who may write everywhere
    ASSERT_TRUE(!root || seteuid(65534) == 0) << "nobody";
    EXPECT_NO_THROW(EXPECT_EQ(reading(file).size(), 4));
    EXPECT_THROW(adding(file), InputError);
    ASSERT_TRUE(!root || seteuid(0) == 0);
    fs::permissions(folder_, fs::perms::owner_all);
  };
  expect_readable();
  {  // a reader keeps it from being closed wholly
    auto writer = std::make_unique<Store>(adding(file));
    const Store reader = reading(file);
    writer.reset();
  }
  expect_readable();
}

TEST(RunKey, IsNamedWithAllOfItAndFoundAgainByItsAddress) {
  const RunKey key = {{"valley", "count", "plain", "fast", 20, "measured"}, 3, 4};
  EXPECT_EQ(
      name_of(key),
      "run 4 of fast on instance 3 of valley (formulation count, perturbation plain, budget 20, "
      "gradient price measured)");
  EXPECT_EQ(address_of(key), "valley/count/plain/fast/20/measured/3/4");
  EXPECT_EQ(key_at(address_of(key)), key);
  for (const char* none : {"", "17", "valley/count/plain/fast/20/n/3", "a/b/c/d/20/n/3/4/5",
                           "a/b/c/d/x/n/3/4", "a/b/c/d/20/n/-3/4", "a/b/c/d/20/n/3/4 "}) {
    EXPECT_FALSE(key_at(none)) << none;
  }
}

TEST(RepeatedTerminations, KeepTheirOrder) {
  EXPECT_THAT(repeated({{"a"}, {"a"}, {"b"}, {"a"}}),
              ElementsAre(FieldsAre("a", 2), FieldsAre("b", 1), FieldsAre("a", 1)));
}

}  // namespace
}  // namespace ricochet
