#include "src/studies/impact_test/tool.h"

#include <gmock/gmock.h>

#include "ricochet/error.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* text = R"(
[[tool]]
name = "some"
title = "Some tool"
kind = "event location"
packages = ["some-dev"]
source = "some.cpp"
compile = "$CXX $SOURCE -o $OUT"
run = ["$OUT", "fast"]
version = ["echo 1"]
loose = "1e-4"
usual = "1e-6"
tight = "1e-12"
sets = "both"
advice = "none"
)";

TEST(Tool, IsReadFromAFile) {
  const ScratchFolder folder;
  const auto tools = tools_in(write_file(folder.path() / "tools.toml", text));
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].name, "some");
  EXPECT_THAT(tools[0].run, ElementsAre("$OUT", "fast"));
  EXPECT_EQ(tools[0].source, folder.path() / "some.cpp");
  EXPECT_EQ(tools[0].levels[static_cast<std::size_t>(Level::tight)], "1e-12");
}

TEST(Tool, IsRefusedWhereTheFileIsWrong) {
  const ScratchFolder folder;
  const auto complaint = [&](std::string changed, const std::string& from, const std::string& to) {
    changed.replace(changed.find(from), from.size(), to);
    try {
      tools_in(write_file(folder.path() / "tools.toml", changed));
      return std::string("none");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(complaint(text, "title", "titel"), HasSubstr("there is no key titel"));
  EXPECT_THAT(complaint(text, "run = [\"$OUT\", \"fast\"]", ""), HasSubstr("run is missing"));
  EXPECT_THAT(complaint(text, "[\"some-dev\"]", "7"), HasSubstr("packages = 7: must be a text"));
  EXPECT_THAT(complaint(text, "\"some\"", "\"a/b\""), HasSubstr("a/b"));
  EXPECT_THAT(complaint(std::string(text) + text, "1e-4", "1e-3"), HasSubstr("twice"));
}

TEST(Tool, MayBeOnesOwn) {
  const Tool tool = own_tool("mine=python3 my.py  fast");
  EXPECT_EQ(tool.name, "mine");
  EXPECT_THAT(tool.run, ElementsAre("python3", "my.py", "fast"));
  for (const char* wrong : {"", "mine", "mine=", "=x", "a/b=x"}) {
    EXPECT_THROW(own_tool(wrong), InputError) << wrong;
  }
}

}  // namespace
}  // namespace ricochet::studies::impact_test
