#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

TEST(Scene, IsPrintedAsAFileThatSimulatesTheSame) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C2").out);
  const std::string mine = call("simulate --format json --scene " + file.string()).out;
  EXPECT_EQ(mine, call("simulate --format json --case C2").out);
  EXPECT_THAT(mine, testing::HasSubstr("\"count\": 24"));
}

TEST(Scene, IsRefusedWithFileKeyValueAndRange) {
  const auto folder = fresh_folder();
  std::string text = call("scene --case C1").out;
  text.replace(text.find("mass = 1.2"), 10, "mass = -1");
  const auto file = write(folder, "machine.toml", text);
  for (const char* command : {"simulate", "threshold", "scene"}) {
    expect_refusal(std::string(command) + " --scene " + file.string(),
                   "machine.toml: scene.mass = -1: must be a finite number > 0 [kg]");
  }
}

TEST(Scene, IsRefusedIfMissingTruncatedOrAFolder) {
  const auto folder = fresh_folder();
  expect_refusal("simulate --scene " + (folder / "none.toml").string(), "none.toml");
  expect_refusal("simulate --scene " + folder.string(), "cannot be read");
  const std::string text = call("scene --case C1").out;
  const auto file = write(folder, "machine.toml", text.substr(0, text.size() / 2));
  expect_refusal("simulate --scene " + file.string(), "machine.toml");
}

TEST(Scene, MustBeOneAndKnown) {
  expect_refusal("simulate", "--case ID");
  expect_refusal("simulate --case C1 --scene machine.toml", "--case ID");
  expect_refusal("simulate --case C13", "C13: there is no such case; allowed: C1, C2");
}

}  // namespace
}  // namespace ricochet::cli
