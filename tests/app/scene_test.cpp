#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

TEST(Scene, IsPrintedAsAFileThatSimulatesTheSame) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C2").out);
  const std::string mine = call("simulate --format json --scene " + file.string()).out;
  EXPECT_EQ(mine, call("simulate --format json --case C2").out);
  EXPECT_GT(nlohmann::json::parse(mine)["count"], 0);
}

TEST(Scene, SaysWhatOfACaseIsFitted) {
  const std::string text = call("scene --case C2").out;
  EXPECT_THAT(text,
              testing::StartsWith("# C2, in the default interpretation of the paper. Fitted to "
                                  "the paper's thresholds"));
  EXPECT_THAT(text, testing::HasSubstr("# measured: centrifugal_mass_radius, wall_upper, "
                                       "start_velocity, revolutions, counting_limit.\n"));
  const auto file = write(fresh_folder(), "machine.toml", text);
  EXPECT_EQ("\n" + call("scene --scene " + file.string()).out, text.substr(text.find("\n[scene]")));
}

TEST(Scene, TakesSettings) {
  const auto file = write(fresh_folder(), "machine.toml", call("scene --case C2").out).string();
  for (const std::string& scene : {"--scene " + file, std::string("--case C2")}) {
    const std::string out =
        call("scene " + scene + " --set friction=0.3 --set 'wall_upper=0.9 mm' --set seconds=4")
            .out;
    EXPECT_THAT(out, testing::HasSubstr("\nfriction = 0.3 "));
    EXPECT_THAT(out, testing::HasSubstr("\nwall_upper = 0.0009 "));
    EXPECT_THAT(out, testing::HasSubstr("\nseconds = 4.0\n"));
  }
  EXPECT_THAT(call("simulate --set omega=2 --scene " + file).out,
              testing::StartsWith("machine with omega=2 at 2 rad/s"));
  expect_refusal("simulate --case C2 --set friction", "--set friction: must be KEY=VALUE");
  expect_refusal("simulate --case C2 --set friction=x",
                 "C2 with --set friction=x: scene.friction = 'x': must be a number");
  expect_refusal("simulate --set friction=0.3", "--case ID");
}

TEST(Scene, IsRefusedWithFileKeyValueAndRange) {
  const auto folder = fresh_folder();
  std::string text = call("scene --case C1").out;
  const std::size_t mass = text.find("mass = ");
  text.replace(mass, text.find('\n', mass) - mass, "mass = -1");
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
  expect_refusal("simulate --case C1 --scene machine.toml", "only one of --case and --scene");
  expect_refusal("simulate --case C13",
                 "C13: there is no such case; did you mean C1 or C3 or C10?");
  expect_refusal("simulate --case X99", "X99: there is no such case; allowed: C1, C2");
}

TEST(Scene, IsReadFromStandardInput) {
  const auto file = write(fresh_folder(), "machine.toml", call("scene --case C2").out);
  for (const char* scene :
       {"simulate --format json --scene", "list problems --scene", "scene --scene"}) {
    EXPECT_EQ(call(fmt::format("{} - <{}", scene, file.string())).out,
              call(fmt::format("{} {}", scene, file.string())).out);
  }
  expect_refusal("simulate --scene - </dev/null", "standard input: the table [scene] is missing");
}

TEST(Scene, OfACaseIsFoundInEitherLetterCase) {
  EXPECT_EQ(call("scene --case c10").out, call("scene --case C10").out);
  EXPECT_THAT(call("simulate --case c1").out, testing::StartsWith("C1 at"));
}

TEST(Scene, WithAMistypedKeyIsToldWhatWasMeant) {
  std::string text = call("scene --case C1").out;
  text.replace(text.find("friction"), 8, "fricton");
  const auto file = write(fresh_folder(), "machine.toml", text);
  expect_refusal("scene --scene " + file.string(),
                 "there is no key scene.fricton; did you mean friction or");
}

TEST(Scene, ThatCannotBeReachedIsRefused) {
  const auto folder = fresh_folder();
  std::filesystem::create_symlink("loop", folder / "loop");
  for (const std::string command :
       {"simulate --scene ", "scene --scene ", "report ", "list problems --scene ",
        "simulate --case C1 --csv ", "reproduce --quick --out ", "calibrate --quick --out ",
        "report " RICOCHET_SOURCE "/reports/reference/reproduction --out "}) {
    expect_refusal(command + (folder / "loop").string(), "loop");
    expect_refusal(command + (folder / "loop" / "deeper").string(), "loop");
  }
}

}  // namespace
}  // namespace ricochet::cli
