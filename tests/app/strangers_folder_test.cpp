#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/app/tool.h"

/// Folders in which somebody put links, pipes and the like where ricochet reads and writes.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StrangersFolder : public testing::Test {
 protected:
  void SetUp() override {
    plan_ = write(folder_, "plan.toml",
                  "name = \"small\"\n[[part]]\nproblems = [\"hs-71\", \"count-C1\"]\n"
                  "solvers = [\"random-search\"]\nbudgets = [20]\ninstances = 2\n")
                .string();
    ASSERT_EQ(call(fmt::format("run {} --out {}", plan_, made_.string())).exit_code, 0);
    write(folder_, "mine.txt", "mine\n");
    fs::create_directory(folder_ / "documents");
    write(folder_ / "documents", "index.html", "mine\n");
    write(folder_ / "documents", "data.json", "{}\n");
  }

  /// What somebody may put in place of a file.
  std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> traps() const {
    const fs::path mine = folder_ / "mine.txt";
    const fs::path nothing = folder_ / "nothing.txt";
    return {{"link", [=](const fs::path& at) { fs::create_symlink(mine, at); }},
            {"link to nothing", [=](const fs::path& at) { fs::create_symlink(nothing, at); }},
            {"link to a device", [](const fs::path& at) { fs::create_symlink("/dev/full", at); }},
            {"link to itself", [](const fs::path& at) { fs::create_symlink(at, at); }},
            {"pipe", [](const fs::path& at) { mkfifo(at.c_str(), 0600); }},
            {"folder", [](const fs::path& at) { fs::create_directory(at); }}};
  }

  /// The command is refused at once, and nothing of the user's is changed.
  void expect_nothing_done(const std::string& arguments, const std::string& what) const {
    const Outcome outcome = call_interrupted("KILL", arguments, 60);
    EXPECT_EQ(outcome.exit_code, 2) << what << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("ricochet: ")) << what;
    EXPECT_EQ(read(folder_ / "mine.txt"), "mine\n") << what;
    EXPECT_FALSE(fs::exists(folder_ / "nothing.txt")) << what;
    EXPECT_EQ(read(folder_ / "documents" / "index.html"), "mine\n") << what;
    EXPECT_EQ(read(folder_ / "documents" / "data.json"), "{}\n") << what;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "documents"), {}), 2) << what;
  }

  const fs::path folder_ = fresh_folder();
  const fs::path made_ = folder_ / "made";
  std::string plan_;
};

TEST_F(StrangersFolder, IsWrittenOnlyAsFilesOfItsOwn) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(made_)) {
    const fs::path file = entry.path().lexically_relative(made_);
    const bool one_of_a_kind =
        file.extension() != ".csv" || file.filename() == "held-out.csv";  // a kind is enough
    if (entry.is_regular_file() && one_of_a_kind) files.push_back(file);
  }
  ASSERT_GT(files.size(), 8U);
  for (const fs::path& file : files) {
    for (const auto& [kind, put] : traps()) {
      const fs::path copy = folder_ / "copy";
      fs::remove_all(copy);
      fs::copy(made_, copy, fs::copy_options::recursive);
      fs::remove(copy / "runs.sqlite");
      fs::remove(copy / file);
      put(copy / file);
      if (file == "runs.sqlite") continue;  // below: it is not written by `report`
      expect_nothing_done("report " + copy.string(), file.string() + ", " + kind);
    }
  }
}

TEST_F(StrangersFolder, HasNoFoldersThatLeadElsewhere) {
  std::vector<std::string> below;
  for (const auto& entry : fs::directory_iterator(made_)) {
    if (entry.is_directory()) below.push_back(entry.path().filename().string());
  }
  ASSERT_GT(below.size(), 2U);
  for (const std::string& name : below) {
    const fs::path copy = folder_ / "copy";
    fs::remove_all(copy);
    fs::copy(made_, copy, fs::copy_options::recursive);
    fs::remove(copy / "runs.sqlite");
    fs::remove_all(copy / name);
    fs::create_directory_symlink(folder_ / "documents", copy / name);
    expect_nothing_done("report " + copy.string(), name);
  }
}

TEST_F(StrangersFolder, IsNoPlaceToGoOnWhereItsFilesAreLinks) {
  for (const char* file : {"runs.sqlite", "runs.sqlite-wal", "summary.md", "index.html",
                           "data.json", "manifest.txt"}) {
    for (const auto& [kind, put] : traps()) {
      const fs::path copy = folder_ / "copy";
      fs::remove_all(copy);
      fs::copy(made_, copy, fs::copy_options::recursive);
      fs::remove(copy / file);
      put(copy / file);
      if (kind == "link" && std::string(file) == "runs.sqlite") {  // to a store that is whole
        fs::remove(copy / file);
        fs::create_symlink(made_ / "runs.sqlite", copy / file);
      }
      const std::string before = read(made_ / "runs.sqlite");
      expect_nothing_done(fmt::format("run {} --out {} --resume", plan_, copy.string()),
                          fmt::format("{}, {}", file, kind));
      EXPECT_EQ(read(made_ / "runs.sqlite") == before, true);
    }
  }
}

/// The pages around the reports too: front, navigation, docs, live machine.
TEST_F(StrangersFolder, IsNoSiteWhereItsPagesAreLinks) {
  const fs::path site = folder_ / "reports";
  fs::create_directory(site);
  fs::copy(made_, site / "made", fs::copy_options::recursive);
  fs::remove(site / "made" / "runs.sqlite");
  ASSERT_EQ(call("report " + site.string()).exit_code, 0);
  for (const char* file : {"index.html", "summary.md", "data.json", "manifest.txt",
                           "live/index.html", "docs/index.html", "docs/security/index.html",
                           "cite/index.html", "made/index.html", "made/data.json"}) {
    ASSERT_TRUE(fs::is_regular_file(site / file)) << file;
    for (const auto& [kind, put] : traps()) {
      const fs::path kept = folder_ / "kept";
      fs::rename(site / file, kept);
      put(site / file);
      expect_nothing_done("report " + site.string(), fmt::format("{}, {}", file, kind));
      fs::remove_all(site / file);
      fs::rename(kept, site / file);
    }
  }
  for (const char* name : {"live", "docs", "docs/security", "cite", "made"}) {
    const fs::path kept = folder_ / "kept";
    fs::rename(site / name, kept);
    fs::create_directory_symlink(folder_ / "documents", site / name);
    expect_nothing_done("report " + site.string(), name);
    fs::remove(site / name);
    fs::rename(kept, site / name);
  }
  ASSERT_EQ(call("report " + site.string()).exit_code, 0);
}

}  // namespace
}  // namespace ricochet::cli
