#include "src/report/report_files.h"

#include <regex>

#include "ricochet/error.h"
#include "src/report/report.h"
#include "src/report/text.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;
using testing::UnorderedElementsAre;

class ReportFiles : public TemporaryFolder {
 protected:
  /// Each name in a folder with its text, which of a folder is "".
  static std::map<std::string, std::string> content(const fs::path& folder) {
    std::map<std::string, std::string> found;
    for (const fs::path& path : fs::directory_iterator(folder)) {
      const bool is_text = fs::is_regular_file(path) && path.filename() != "manifest.txt";
      found[path.filename().string()] = is_text ? text_of(path) : "";
    }
    return found;
  }
};

TEST_F(ReportFiles, ReplaceAnEarlierReportAndNothingElse) {
  const fs::path folder = folder_ / "a" / "b";
  replace_files(folder, {{"old.svg", "old"}, {"both.svg", "1"}, {"changed.svg", "old"}});
  write_file(folder / "notes.txt", "mine");
  write_file(folder / "logo.svg", "old");
  write_file(folder / "changed.svg", "by the user");
  replace_files(folder, {{"both.svg", "2"}, {"new.svg", "new"}});
  EXPECT_THAT(content(folder),
              UnorderedElementsAre(Pair("manifest.txt", ""), Pair("both.svg", "2"),
                                   Pair("new.svg", "new"), Pair("notes.txt", "mine"),
                                   Pair("logo.svg", "old"), Pair("changed.svg", "by the user")));
}

TEST_F(ReportFiles, OfAManifestThatSomeoneWroteTouchNothingElsewhere) {
  for (const char* folder : {"a", "b"}) replace_files(folder_ / folder, {{"old.svg", "old"}});
  const fs::path manifest = folder_ / "a" / "manifest.txt";
  write_file(manifest, std::regex_replace(text_of(manifest), std::regex("old"), "../b/old"));
  replace_files(folder_ / "a", {{"new.svg", "new"}});
  EXPECT_TRUE(fs::exists(folder_ / "b" / "old.svg"));
}

TEST_F(ReportFiles, AreNotWrittenIntoAFolderThatCannotBe) {
  const fs::path file = write_file(folder_ / "file", "mine");
  for (const fs::path& folder : {file, file / "deeper" / "still"}) {
    EXPECT_THAT(complaint_of([&] {
                  replace_files(folder, {{"new.svg", "new"}});
                }),
                AllOf(HasSubstr(file.string()), Not(HasSubstr("\n"))));
  }
  EXPECT_THAT(content(folder_), UnorderedElementsAre(Pair("file", "mine")));
}

TEST_F(ReportFiles, StayAsTheyWereIfOneCannotBeReplaced) {
  replace_files(folder_, {{"index.html", "before"}, {"old.svg", "old"}});
  fs::create_directory(folder_ / "new.svg");
  EXPECT_THROW(replace_files(folder_, {{"index.html", "after"}, {"new.svg", "new"}}), InputError);
  EXPECT_THAT(content(folder_),
              UnorderedElementsAre(Pair("index.html", "before"), Pair("manifest.txt", ""),
                                   Pair("old.svg", "old"), Pair("new.svg", "")));
}

/// Results that no page fits: drawing them fails.
Json unfit(const char* report) {
  return {{"report", report}, {"computed", "for hours"}};
}

TEST_F(ReportFiles, KeepTheDataOfAllPagesOfAReportThatCannotBeDrawn) {
  Json data = unfit("comparison");
  for (const char* name : {"one", "two"})
    data["pages"].push_back({{"folder", name}, {"data", unfit("comparison_family")}});
  EXPECT_THROW(static_cast<void>(write_report(data, folder_)), std::logic_error);
  const auto kept = [&](const char* folder) {
    return data_in(text_of(folder_ / folder / "data.json"));
  };
  EXPECT_EQ(kept(""),
            (Json{{"report", "comparison"}, {"computed", "for hours"}, {"pages", {"one", "two"}}}));
  for (const char* name : {"one", "two"}) EXPECT_EQ(kept(name), unfit("comparison_family"));
}

}  // namespace
}  // namespace ricochet::report
