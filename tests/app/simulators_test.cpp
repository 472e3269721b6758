#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A tool that loses every impact.
std::string quiet_tool(const std::filesystem::path& folder) {
  const auto file = write(folder, "quiet.sh",
                          "while read -r line; do echo '{\"impacts\":[],\"seconds\":1}'; done\n");
  return "--tool 'quiet=sh " + file.string() + "'";
}

TEST(Simulators, ComparesAToolOfOnesOwn) {
  const auto folder = fresh_folder();
  const auto out = (folder / "out").string();
  const std::string command = "simulators --tools none --quick --scenes 11 --levels usual --out " +
                              out + " " + quiet_tool(folder);
  const Outcome outcome = call(command + " --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["values"]["scenes"], 11);
  EXPECT_EQ(json["values"]["lost"], 0);
  const auto& tools = json["tables"]["simulators"];
  EXPECT_EQ(tools["columns"][2]["name"], "missed");
  EXPECT_EQ(tools["rows"][0][0], "ricochet");
  const auto quiet = std::ranges::find_if(
      tools["rows"], [](const ordered_json& row) { return row[0] == "quiet"; });
  ASSERT_NE(quiet, tools["rows"].end());
  EXPECT_EQ((*quiet)[2], 1000);
  const std::string html = read(folder / "out" / "index.html");
  EXPECT_THAT(
      html, AllOf(HasSubstr("quiet"), HasSubstr("What restitution does a contact law"),
                  Not(HasSubstr("<script src")), Not(HasSubstr("<link")), Not(HasSubstr("<img"))));
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

TEST(Simulators, ListsItsTools) {
  const auto tools = ordered_json::parse(
      call("simulators --list-tools --format json --tools ode --out " + fresh_folder().string())
          .out);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0]["tool"], "ode");
}

TEST(Simulators, RefusesWhatItDoesNotKnow) {
  expect_refusal("simulators --tools no-such-tool", "no-such-tool");
  expect_refusal("simulators --tools none --levels exact", "exact");
  expect_refusal("simulators --tools none --tool x", "NAME=COMMAND");
  expect_refusal("simulators --tools none --tool a=b --tool a=c", "taken");
  expect_refusal("simulators --tools none --scenes 0", "--scenes");
}

TEST(Simulators, RefuseAFolderThatCannotBeWrittenBeforeTheyWork) {
  const auto file = write(fresh_folder(), "file", "mine");
  expect_refusal("simulators --tools none --out " + (file / "report").string(), "file/report");
  EXPECT_EQ(read(file), "mine");
}

TEST(Simulators, AreNamedInTheAnswerToTheFormerNames) {
  for (const char* former : {"dynamics", "impact-test", "dynamics --quick", "impact-test --help"})
    expect_refusal(former, "`simulators`");
}

}  // namespace
}  // namespace ricochet::cli
