#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "problems/carrier_track/suite/machine.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(Simulate, PrintsTheJsonOfTheContract) {
  const Outcome outcome = call("simulate --case C2 --omega 1.9 --format json");
  ASSERT_EQ(outcome.exit_code, 0);
  const auto json = ordered_json::parse(outcome.out);
  EXPECT_THAT(keys_of(json),
              ElementsAre("count", "surrogate", "certain", "complete", "reached", "margin", "graze",
                          "growth", "doubt", "impacts", "peaks", "end", "evaluations", "fidelity"));
  EXPECT_EQ(json["certain"], true);
  EXPECT_EQ(json["fidelity"], "impact");
  EXPECT_THAT(keys_of(json["impacts"][0]), ElementsAre("time", "wall", "speed"));
  EXPECT_THAT(json["impacts"][0]["wall"], testing::AnyOf("lower", "upper"));
  EXPECT_THAT(keys_of(json["peaks"][0]), ElementsAre("time", "position"));
  EXPECT_THAT(keys_of(json["end"]), ElementsAre("time", "position", "velocity"));
  std::size_t fast = 0;
  const double slowest = carrier_track::default_machine().counting_limit;
  for (const auto& impact : json["impacts"]) fast += impact["speed"] > slowest ? 1 : 0;
  EXPECT_GT(fast, 5U);
  EXPECT_EQ(json["count"], fast);
  EXPECT_GT(json["impacts"].size(), fast);
}

TEST(Simulate, TakesTheLevelOfTheModel) {
  const auto json =
      ordered_json::parse(call("simulate --case C4 --fidelity compliant --format json").out);
  EXPECT_EQ(json["fidelity"], "compliant");
  EXPECT_NE(json["count"], 6) << "a wall as soft as the default is another machine";
}

TEST(Simulate, ExplainsItselfToPeople) {
  const Outcome outcome = call("simulate --case C1");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("C1 at 3 rad/s: 5 collisions"));
  EXPECT_THAT(outcome.out, HasSubstr("counts"));
}

/// Whether what a line of the table tells of counts; nothing for other lines.
std::vector<bool> marks_in(const std::string& text) {
  std::vector<bool> marks;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with("✓") || line.ends_with("✗")) marks.push_back(line.ends_with("✓"));
  }
  return marks;
}

TEST(Simulate, MarksWhatTheRuleCounts) {
  const auto folder = fresh_folder();
  const std::string scene = call("scene --case C1").out;
  const std::string impacts = "rule = \"impacts\"";
  std::string by_peaks = scene;
  by_peaks.replace(scene.find(impacts), impacts.size(), "rule = \"peaks\"");
  for (const std::string& text : {scene, by_peaks}) {
    const std::string file = write(folder, "machine.toml", text).string();
    const auto json = ordered_json::parse(call("simulate --format json --scene " + file).out);
    const std::string shown = call("simulate --scene " + file).out;
    EXPECT_GT(json["count"], 0);
    const std::vector<bool> marks = marks_in(shown);
    EXPECT_EQ(std::ranges::count(marks, true), json["count"]) << shown;
    EXPECT_TRUE(std::ranges::is_sorted(marks, std::greater())) << "not first:\n" << shown;
    EXPECT_THAT(shown, HasSubstr(text == scene ? "speed" : "maximum"));
  }
}

TEST(Simulate, WritesThePathAndItsPicture) {
  const auto folder = fresh_folder();
  const Outcome outcome = call("simulate --case C1 --csv " + (folder / "path.csv").string() +
                               " --plot " + (folder / "path.svg").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string csv = read(folder / "path.csv");
  const double start = carrier_track::default_machine().start_position;
  const std::string head = fmt::format("time_s,position_m,velocity_m_per_s\n0,{},", start);
  EXPECT_THAT(csv, testing::StartsWith(head));
  EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 2000);
  EXPECT_THAT(read(folder / "path.svg"), HasSubstr("<svg"));
  EXPECT_THAT(read(folder / "path.svg"), HasSubstr("5 collisions"));
}

TEST(Simulate, WritesNoRowTwice) {
  const auto folder = fresh_folder();
  for (const std::string scene :
       {"--case C1", "--case C4 --omega 9", "--case C1 --fidelity compliant"}) {
    ASSERT_EQ(call("simulate " + scene + " --csv " + (folder / "path.csv").string()).exit_code, 0);
    std::istringstream rows(read(folder / "path.csv"));
    std::set<std::string> seen;
    for (std::string row; std::getline(rows, row);) {
      EXPECT_TRUE(seen.insert(row).second) << row;
    }
    EXPECT_GT(seen.size(), 1000U);
  }
}

/// Bounces on the lower wall for a tenth of the window, and rests for the other nine.
constexpr const char* dropped =
    "[scene]\nmass=1\nwall_lower=0\nwall_upper=1\nrestitution=0.5\npull=40\n"
    "start_position=0.05\n[window]\nseconds=5\n";

TEST(Simulate, DrawsWhatCountsAndWhereItHappens) {
  const auto folder = fresh_folder();
  const std::string file = write(folder, "machine.toml", dropped).string();
  const std::string svg = (folder / "path.svg").string();
  ASSERT_EQ(call("simulate --scene " + file + " --plot " + svg).exit_code, 0);
  EXPECT_THAT(read(svg), testing::AllOf(HasSubstr(">impact that counts</text>"),
                                        HasSubstr("Where most of what counts happens")));
  ASSERT_EQ(call("simulate --case C2 --omega 10 --plot " + svg).exit_code, 0);
  EXPECT_THAT(read(svg), testing::AllOf(HasSubstr(">impact that counts</text>"),
                                        testing::Not(HasSubstr("Where most"))));
}

TEST(Simulate, RefusesSpeedsThatNoPlateTurnsAt) {
  for (const char* omega : {"0", "-1", "nan", "inf"}) {
    expect_refusal(std::string("simulate --case C1 --omega ") + omega, "--omega = ");
  }
  expect_refusal("simulate --case C1 --smoothing 0", "--smoothing");
  expect_refusal("simulate --case C1 --fidelity perfect", "--fidelity");
}

TEST(Simulate, NeverWritesOverItsInput) {
  const auto folder = fresh_folder();
  const std::string text = call("scene --case C1").out;
  const auto scene = write(folder, "machine.toml", text);
  std::filesystem::create_symlink(scene, folder / "link");
  std::filesystem::create_hard_link(scene, folder / "same");
  for (const char* name : {"machine.toml", "link", "same", "../Simulate/machine.toml"}) {
    for (const char* option : {"--csv ", "--plot "}) {
      const auto file =
          (folder / std::regex_replace(name, std::regex("Simulate"), folder.filename().string()))
              .string();
      expect_refusal("simulate --scene " + scene.string() + " " + option + file, "the input");
      expect_refusal("simulate --scene " + (folder / "link").string() + " " + option + file,
                     "the input");
    }
  }
  EXPECT_EQ(read(scene), text);
  const std::string both = (folder / "both").string();
  expect_refusal("simulate --case C1 --csv " + both + " --plot " + both, "--csv");
  EXPECT_FALSE(std::filesystem::exists(both));
}

/// Not by their names in /dev: a test that fails must not harm them.
TEST(Simulate, WritesThroughStandardOutputAndDevices) {
  const Outcome outcome = call("simulate --case C1 --csv /proc/self/fd/1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::StartsWith("time_s,"));
  EXPECT_THAT(outcome.out, HasSubstr("C1 at 3 rad/s: 5 collisions"));
  const Outcome full = call_with_output("simulate --case C1 --csv /proc/self/fd/1", ">/dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err, "ricochet: /proc/self/fd/1: cannot be written: No space left on device\n");
}

TEST(Simulate, WritesNothingWhereItCannot) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "file", "mine");
  for (const char* option : {"--csv", "--plot"}) {
    expect_refusal("simulate --case C1 " + std::string(option) + " " + (file / "path").string(),
                   "file/path");
  }
  EXPECT_EQ(read(file), "mine");
}

}  // namespace
}  // namespace ricochet::cli
