#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Dynamics, WritesAReportThatStandsAlone) {
  const auto folder = fresh_folder() / "new" / "report";
  const Outcome outcome = call("dynamics --quick --out " + folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr((folder / "index.html").string()));
  const std::string html = read(folder / "index.html");
  EXPECT_THAT(html, HasSubstr("What restitution does a contact law return?"));
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_THAT(read(folder / "summary.md"), HasSubstr("moreau-jean"));
  EXPECT_TRUE(std::filesystem::exists(folder / "restitution.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "mild-work.svg"));
}

TEST(Dynamics, RefusesAFolderThatCannotBeWrittenBeforeItWorks) {
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("dynamics --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

}  // namespace
}  // namespace ricochet::cli
