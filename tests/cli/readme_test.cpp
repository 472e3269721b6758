#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

std::string readme() {
  return read(RICOCHET_SOURCE "/README.md");
}

TEST(Readme, ShowsASolverThatIsReallyThere) {
  const std::string text = readme();
  const std::string fence = "```cpp\n";
  const auto start = text.find(fence) + fence.size();
  const std::string code = text.substr(start, text.find("```", start) - start);
  EXPECT_GT(code.size(), 100U);
  EXPECT_THAT(read(RICOCHET_SOURCE "/solvers/random_search.cpp"), testing::HasSubstr(code));
}

TEST(Readme, ListsTheKeysOfAScene) {
  const std::string text = readme();
  const std::string scene = call("scene --case C1").out;
  int keys = 0;
  std::istringstream lines(scene);
  for (std::string line; std::getline(lines, line);) {
    const auto end = line.find(" = ");
    if (end == std::string::npos) continue;
    EXPECT_THAT(text, testing::HasSubstr(fmt::format("`{}`", line.substr(0, end))));
    ++keys;
  }
  EXPECT_GT(keys, 20);
}

TEST(Readme, BringsAMachineOfYourOwnByCommandsThatWork) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C1").out);
  EXPECT_EQ(call("threshold --scene " + file.string()).exit_code, 0);
  EXPECT_EQ(call("simulate --scene " + file.string() + " --omega 5 --plot " +
                 (folder / "path.svg").string())
                .exit_code,
            0);
}

}  // namespace
}  // namespace ricochet::cli
