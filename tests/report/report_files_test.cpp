#include "src/report/report_files.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "ricochet/error.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;
using testing::UnorderedElementsAre;

class ReportFiles : public testing::Test {
 protected:
  ReportFiles()
      : root_(fs::path(testing::TempDir()) /
              (std::string("report_files_") + std::to_string(getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(root_);
  }
  ~ReportFiles() override { fs::remove_all(root_); }

  static std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

  static std::set<std::string> names(const fs::path& folder) {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
      found.insert(entry.path().filename().string());
    return found;
  }

  fs::path root_;
};

TEST_F(ReportFiles, ReplaceAnEarlierReportAndNothingElse) {
  replace_files(root_ / "a" / "b", {{"old.svg", "old"}, {"both.svg", "1"}});
  const fs::path folder = root_ / "a" / "b";
  write(folder / "notes.txt", "mine");
  write(folder / "logo.svg", "old");
  replace_files(folder, {{"both.svg", "2"}, {"new.svg", "new"}});
  EXPECT_THAT(names(folder),
              UnorderedElementsAre("manifest.txt", "both.svg", "new.svg", "notes.txt", "logo.svg"));
  EXPECT_EQ(read(folder / "both.svg"), "2");
  EXPECT_EQ(read(folder / "notes.txt"), "mine");
}

TEST_F(ReportFiles, LeaveWhatTheUserHasChangedSince) {
  replace_files(root_, {{"old.svg", "old"}});
  write(root_ / "old.svg", "mine");
  replace_files(root_, {{"new.svg", "new"}});
  EXPECT_TRUE(fs::exists(root_ / "old.svg"));
}

TEST_F(ReportFiles, OfAManifestThatSomeoneWroteTouchNothingElsewhere) {
  for (const char* folder : {"a", "b"}) replace_files(root_ / folder, {{"old.svg", "old"}});
  const fs::path manifest = root_ / "a" / "manifest.txt";
  write(manifest, std::regex_replace(read(manifest), std::regex("old"), "../b/old"));
  replace_files(root_ / "a", {{"new.svg", "new"}});
  EXPECT_TRUE(fs::exists(root_ / "b" / "old.svg"));
}

TEST_F(ReportFiles, AreNotWrittenIntoAFolderThatCannotBe) {
  write(root_ / "file", "mine");
  for (const fs::path& folder : {root_ / "file", root_ / "file" / "deeper" / "still"})
    EXPECT_THAT(
        [&] {
          replace_files(folder, {{"new.svg", "new"}});
        },
        ThrowsMessage<InputError>(
            AllOf(HasSubstr((root_ / "file").string()), Not(HasSubstr("\n")))));
  EXPECT_THAT(names(root_), UnorderedElementsAre("file"));
  EXPECT_EQ(read(root_ / "file"), "mine");
}

TEST_F(ReportFiles, StayAsTheyWereIfOneCannotBeReplaced) {
  replace_files(root_, {{"index.html", "before"}, {"old.svg", "old"}});
  fs::create_directory(root_ / "new.svg");
  EXPECT_THROW(replace_files(root_, {{"index.html", "after"}, {"new.svg", "new"}}), InputError);
  EXPECT_EQ(read(root_ / "index.html"), "before");
  EXPECT_THAT(names(root_),
              UnorderedElementsAre("index.html", "manifest.txt", "old.svg", "new.svg"));
}

}  // namespace
}  // namespace ricochet::report
