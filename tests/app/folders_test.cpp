#include <sys/stat.h>

#include "src/core/files.h"
#include "tests/app/tool.h"

/// Folders that go away, that others work in, or in which somebody put links, pipes and the like
/// where ricochet reads and writes; and commands that are interrupted.
namespace ricochet::cli {
namespace {

/// Interrupts a call later and later, until it has begun its work: a busy machine has nothing yet
/// after a second.
Outcome interrupted_at_work(const std::string& arguments) {
  Outcome outcome{};
  for (int seconds = 1; seconds < 100; seconds *= 2) {
    outcome = call_interrupted("INT", arguments, seconds);
    if (outcome.err != "ricochet: interrupted\n") break;
  }
  return outcome;
}

TEST(Interruption, KeepsWhatIsFinishedAndSaysHowToGoOn) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const Outcome outcome =
      interrupted_at_work("best-values --problems 'top-speed-*' --out best.toml");
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err,
            "ricochet: interrupted; finished searches are kept in best.toml.part: the same command "
            "goes on\n");
  EXPECT_FALSE(exists("best.toml"));
}

TEST(Interruption, OfAComparisonThatHasNoRunsYetSaysHowToGoOn) {
  const Outcome outcome = interrupted_at_work("compare --out report");
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, EndsWith("ricochet: interrupted; no run was made: the same command "
                                    "starts again\n"));
}

TEST(Interruption, OfAStudyLeavesNoTrace) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const Outcome outcome = call_interrupted("TERM", "verify --scenes 10000000 --out new/report");
  EXPECT_EQ(outcome.exit_code, 143);
  EXPECT_EQ(outcome.err, "ricochet: interrupted\n");
  EXPECT_TRUE(fs::is_empty(here()));
}

TEST(FolderLock, HasASecondCallSayThatThereIsAFirst) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const FolderLock first(here() / "report");
  for (const std::string command :
       {"reproduce --quick --out report", "calibrate --quick --out report",
        "surrogate --quick --out report", "best-values --out report/best.toml",
        "report " RICOCHET_SOURCE "/reports/reference/reproduction --out report"}) {
    expect_refusal(command, "another ricochet is at work there");
  }
}

TEST(DailyUse, NoticesThatItsFolderIsGone) {
  write("plan.toml",
        "name = \"long\"\n[[part]]\nproblems = [\"hs-*\", \"count-*\"]\n"
        "solvers = [\"random-search\", \"nlopt-cobyla\"]\nbudgets = [5000]\ninstances = 15\n");
  const fs::path made = here() / "made", elsewhere = here() / "elsewhere";
  for (const bool moved : {false, true}) {
    std::thread removing([&] {
      while (!fs::exists(made / "runs.sqlite")) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::seconds(1));
      if (moved) {
        fs::rename(made, elsewhere);
      } else {
        fs::remove_all(made);
      }
    });
    const Outcome outcome = call_interrupted("KILL", "run plan.toml --out made", 30);
    removing.join();
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("made/runs.sqlite: was removed while runs were added"));
    EXPECT_FALSE(exists("made/index.html"));
  }
}

class StrangersFolder : public testing::Test {
 protected:
  void SetUp() override {
    write("plan.toml",
          "name = \"small\"\n[[part]]\nproblems = [\"hs-71\", \"count-C1\"]\n"
          "solvers = [\"random-search\"]\nbudgets = [20]\ninstances = 2\n");
    ASSERT_EQ(call("run plan.toml --out made").exit_code, 0);
    write("mine.txt", "mine\n");
    write("documents/index.html", "mine\n");
    write("documents/data.json", "{}\n");
  }

  /// What somebody may put in place of a file.
  static std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> traps() {
    const fs::path mine = here() / "mine.txt", nothing = here() / "nothing.txt";
    return {{"link", [=](const fs::path& at) { fs::create_symlink(mine, at); }},
            {"link to nothing", [=](const fs::path& at) { fs::create_symlink(nothing, at); }},
            {"link to a device", [](const fs::path& at) { fs::create_symlink("/dev/full", at); }},
            {"link to itself", [](const fs::path& at) { fs::create_symlink(at, at); }},
            {"pipe", [](const fs::path& at) { mkfifo(at.c_str(), 0600); }},
            {"folder", [](const fs::path& at) { fs::create_directory(at); }}};
  }

  /// A copy of what was made, without this file; where it was.
  static fs::path copy_without(const fs::path& file) {
    const fs::path copy = here() / "copy";
    fs::remove_all(copy);
    fs::copy(here() / "made", copy, fs::copy_options::recursive);
    fs::remove_all(copy / file);
    return copy / file;
  }

  /// The command is refused at once, and nothing of the user's is changed.
  static void expect_nothing_done(const std::string& arguments, const std::string& what) {
    const Outcome outcome = call_interrupted("KILL", arguments, 60);
    EXPECT_EQ(outcome.exit_code, 2) << what << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("ricochet: ")) << what;
    EXPECT_EQ(read("mine.txt") + read("documents/index.html") + read("documents/data.json"),
              "mine\nmine\n{}\n")
        << what;
    EXPECT_FALSE(exists("nothing.txt")) << what;
    EXPECT_EQ(std::distance(fs::directory_iterator(here() / "documents"), {}), 2) << what;
  }
};

TEST_F(StrangersFolder, IsWrittenOnlyAsFilesOfItsOwn) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(here() / "made")) {
    const fs::path file = entry.path().lexically_relative(here() / "made");
    // One table is enough. The store is not written by `report`; see below.
    const bool another_table = file.extension() == ".csv" && file.filename() != "held-out.csv";
    if (!entry.is_regular_file() || another_table || file == "runs.sqlite") continue;
    ++files;
    for (const auto& [kind, put] : traps()) {
      put(copy_without(file));
      fs::remove(here() / "copy/runs.sqlite");
      expect_nothing_done("report copy", file.string() + ", " + kind);
    }
  }
  EXPECT_GT(files, 7);
}

TEST_F(StrangersFolder, HasNoFoldersThatLeadElsewhere) {
  int folders = 0;
  for (const auto& entry : fs::directory_iterator(here() / "made")) {
    if (!entry.is_directory()) continue;
    ++folders;
    const fs::path name = entry.path().filename();
    fs::create_directory_symlink(here() / "documents", copy_without(name));
    fs::remove(here() / "copy/runs.sqlite");
    expect_nothing_done("report copy", name);
  }
  EXPECT_GT(folders, 2);
}

TEST_F(StrangersFolder, IsNoPlaceToGoOnWhereItsFilesAreLinks) {
  const std::string before = read("made/runs.sqlite");
  for (const std::string file : {"runs.sqlite", "runs.sqlite-wal", "summary.md", "index.html",
                                 "data.json", "manifest.txt"}) {
    for (const auto& [kind, put] : traps()) {
      const fs::path at = copy_without(file);
      if (kind == "link" && file == "runs.sqlite") {  // to a store that is whole
        fs::create_symlink(here() / "made/runs.sqlite", at);
      } else {
        put(at);
      }
      expect_nothing_done("run plan.toml --out copy --resume", file + ", " + kind);
      EXPECT_TRUE(read("made/runs.sqlite") == before);
    }
  }
}

/// The pages around the reports too: front, navigation, docs, live machine.
TEST_F(StrangersFolder, IsNoSiteWhereItsPagesAreLinks) {
  const fs::path site = here() / "reports", kept = here() / "kept";
  fs::create_directory(site);
  fs::copy(here() / "made", site / "made", fs::copy_options::recursive);
  fs::remove(site / "made/runs.sqlite");
  out_of("report reports");
  for (const std::string file : {"index.html", "summary.md", "data.json", "manifest.txt",
                                 "live/index.html", "docs/index.html", "docs/security/index.html",
                                 "cite/index.html", "made/index.html", "made/data.json"}) {
    ASSERT_TRUE(fs::is_regular_file(site / file)) << file;
    for (const auto& [kind, put] : traps()) {
      fs::rename(site / file, kept);
      put(site / file);
      expect_nothing_done("report reports", file + ", " + kind);
      fs::remove_all(site / file);
      fs::rename(kept, site / file);
    }
  }
  for (const char* name : {"live", "docs", "docs/security", "cite", "made"}) {
    fs::rename(site / name, kept);
    fs::create_directory_symlink(here() / "documents", site / name);
    expect_nothing_done("report reports", name);
    fs::remove(site / name);
    fs::rename(kept, site / name);
  }
  out_of("report reports");
}

}  // namespace
}  // namespace ricochet::cli
