#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Surrogate, WritesAReportThatStandsAlone) {
  const auto folder = fresh_folder() / "new" / "report";
  const Outcome outcome = call("surrogate --quick --out " + folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr((folder / "index.html").string()));
  const std::string html = read(folder / "index.html");
  EXPECT_THAT(html, HasSubstr("Where does the gradient mean something?"));
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "speed-gap.svg"));

  const auto again = folder.parent_path() / "again";
  ASSERT_EQ(call("report " + folder.string() + " --out " + again.string()).exit_code, 0);
  for (const char* file : {"index.html", "summary.md", "bias.csv", "data.json"}) {
    EXPECT_EQ(read(again / file), read(folder / file)) << file;
  }
}

TEST(Surrogate, RefusesAFolderThatCannotBeWrittenBeforeItWorks) {
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("surrogate --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

}  // namespace
}  // namespace ricochet::cli
