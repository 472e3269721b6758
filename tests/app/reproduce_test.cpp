#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Reproduce, WritesAReportThatStandsAlone) {
  const auto folder = fresh_folder() / "new" / "report";
  const Outcome outcome = call("reproduce --quick --out " + folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr((folder / "index.html").string()));
  const std::string html = read(folder / "index.html");
  EXPECT_THAT(html, HasSubstr("How far off are the computed speeds?"));
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  const std::string summary = read(folder / "summary.md");
  EXPECT_THAT(summary, HasSubstr("| C12 |"));
  EXPECT_THAT(summary, HasSubstr("fireworks"));
  EXPECT_TRUE(std::filesystem::exists(folder / "c1-count.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "c1-loud.svg"));
}

TEST(Reproduce, RefusesAFolderThatCannotBeWrittenBeforeItWorks) {
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("reproduce --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

}  // namespace
}  // namespace ricochet::cli
