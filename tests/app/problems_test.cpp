#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Problems, WritesAPageForAMachineOfOnesOwn) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C1").out);
  const Outcome outcome =
      call("problems --scene " + file.string() + " --out " + (folder / "page").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("index.html"));
  const std::string text = read(folder / "page" / "summary.md");
  EXPECT_THAT(text, testing::HasSubstr("machine.toml"));
  EXPECT_THAT(text, testing::HasSubstr("robust-cvar"));
  EXPECT_THAT(read(folder / "page" / "robust-cvar" / "summary.md"),
              testing::HasSubstr("robust-cvar-scene"));
}

TEST(Problems, RefusesABadScene) {
  expect_refusal("problems --scene nowhere.toml", "nowhere.toml");
}

TEST(Problems, RefusesASpeedProfile) {
  std::string text = call("scene --case C1").out;
  const auto key = text.find("omega = ");
  text.replace(key, text.find('\n', key) - key, "omega = [[0.0, 2.0], [1.0, 3.0]]");
  const auto file = write(fresh_folder(), "machine.toml", text);
  expect_refusal("problems --scene " + file.string(), "machine.toml: scene.omega is a profile");
}

}  // namespace
}  // namespace ricochet::cli
