#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

/// A tool that loses every impact.
std::string quiet_tool(const std::filesystem::path& folder) {
  const auto file = write(folder, "quiet.sh",
                          "while read -r line; do echo '{\"impacts\":[],\"seconds\":1}'; done\n");
  return "--tool 'quiet=sh " + file.string() + "'";
}

TEST(ImpactTest, ComparesAToolOfOnesOwn) {
  const auto folder = fresh_folder();
  const auto out = (folder / "out").string();
  const std::string command =
      "impact-test --tools none --scenes 11 --levels usual --out " + out + " " + quiet_tool(folder);
  const Outcome outcome = call(command + " --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["values"]["scenes"], 11);
  EXPECT_EQ(json["values"]["lost"], 0);
  const auto& tools = json["tables"]["tools"];
  EXPECT_EQ(tools["columns"][2]["name"], "missed");
  EXPECT_EQ(tools["rows"][0][0], "ricochet");
  EXPECT_EQ(tools["rows"].back()[0], "quiet");
  EXPECT_EQ(tools["rows"].back()[2], 1000);
  EXPECT_THAT(read(folder / "out" / "index.html"), HasSubstr("quiet"));
  EXPECT_THAT(read(folder / "out" / "scenes.jsonl"), HasSubstr("\"impacts\""));
  // Three scenes that break it, of different kinds; each is a machine.
  std::istringstream lines(read(folder / "out" / "smallest" / "quiet.jsonl"));
  std::vector<ordered_json> scenes;
  for (std::string line; std::getline(lines, line);) scenes.push_back(ordered_json::parse(line));
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_NE(scenes[0]["kind"], scenes[1]["kind"]);
  const ordered_json& smallest = scenes.front();
  const auto machine = write(folder, "machine.toml", smallest["machine"].get<std::string>());
  const auto run =
      ordered_json::parse(call("simulate --format json --scene " + machine.string()).out);
  EXPECT_EQ(run["count"], 1);
  // Again, from what is kept.
  const Outcome again = call(command);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("quiet"));
}

TEST(ImpactTest, ListsItsTools) {
  const auto tools =
      ordered_json::parse(call("impact-test --list-tools --format json --tools scipy-rk45 --out " +
                               fresh_folder().string())
                              .out);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0]["tool"], "scipy-rk45");
}

TEST(ImpactTest, RefusesWhatItDoesNotKnow) {
  expect_refusal("impact-test --tools no-such-tool", "no-such-tool");
  expect_refusal("impact-test --tools none --levels exact", "exact");
  expect_refusal("impact-test --tools none --tool x", "NAME=COMMAND");
  expect_refusal("impact-test --tools none --tool a=b --tool a=c", "taken");
  expect_refusal("impact-test --tools none --scenes 0", "--scenes");
}

}  // namespace
}  // namespace ricochet::cli
