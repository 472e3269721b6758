#include <gmock/gmock.h>

#include "src/studies/impact_test/tool.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A tool whose driver is "compiled" by copying it.
Tool copied_tool(const std::filesystem::path& folder) {
  Tool tool;
  tool.name = "copied";
  tool.source = write_file(folder / "driver.sh", "#!/bin/sh\necho 3.1\n");
  tool.compile = "cp $SOURCE $OUT && chmod +x $OUT";
  tool.run = {"$OUT", "$HERE/data"};
  tool.version = {"$OUT", "--version"};
  return tool;
}

TEST(ToolProgram, IsCompiledOnceAndTellsItsVersion) {
  const ScratchFolder folder;
  Tool tool = copied_tool(folder.path());
  const FoundTool found = found_tool(tool, folder.path() / "drivers");
  ASSERT_TRUE(found.program) << found.reason;
  EXPECT_EQ(found.program->version, "3.1");
  const std::string driver = found.program->command.at(0);
  EXPECT_TRUE(std::filesystem::exists(driver));
  EXPECT_EQ(found.program->command.at(1), (folder.path() / "data").string());
  const auto made = std::filesystem::last_write_time(driver);
  EXPECT_EQ(found_tool(tool, folder.path() / "drivers").program->command.at(0), driver);
  EXPECT_EQ(std::filesystem::last_write_time(driver), made);
  write_file(tool.source, "#!/bin/sh\necho 3.2\n");
  EXPECT_EQ(found_tool(tool, folder.path() / "drivers").program->version, "3.2");
}

TEST(ToolProgram, SaysWhyItIsNotThere) {
  const ScratchFolder folder;
  Tool tool = copied_tool(folder.path());
  tool.version = {"echo no module named x >&2; exit 1"};
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("no module named x"));
  tool.version = {"no-such-program-at-all", "--version"};
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("not installed"));
  tool.compile = "echo header.h is missing >&2; false";
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("header.h is missing"));
}

}  // namespace
}  // namespace ricochet::studies::impact_test
