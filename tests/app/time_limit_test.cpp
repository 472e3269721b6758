// Commands that compute a machine: limit, progress, and what is known when the limit is reached.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string scene = " --scene " RICOCHET_SOURCE "/examples/machine.toml";

/// A disturbance above friction: hours without a limit.
const std::string disturbed = scene + " --set disturbance=3 --set disturbance_frequency=7.3";

/// Calls a command that must end soon after its limit, with exit code 1 and a reason.
Outcome call_limited(const std::string& arguments, int seconds) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = call(arguments + " --seconds " + std::to_string(seconds));
  EXPECT_EQ(outcome.exit_code, 1) << arguments;
  EXPECT_THAT(outcome.err, HasSubstr("the time limit of " + std::to_string(seconds) + " s"))
      << arguments;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(seconds + 20))
      << arguments;
  return outcome;
}

TEST(TimeLimit, EndsEveryCommandThatComputesAMachine) {
  const std::string members[] = {
      "regimes" + disturbed,
      "regimes" + disturbed + " --over clearance=0.0005..0.001",
      "threshold" + scene +
          " --set disturbance=5 --set disturbance_frequency=31 --allow-per-turn "
          "100000",
      "threshold" + scene + " --set window.revolutions=20000 --allow 1000000000",
      "threshold" + scene + " --set window.revolutions=20000 --allow-energy 1e9",
      "simulate" + scene + " --set window.revolutions=900000 --omega 8",
      "regimes" + scene + " --starts 1000000 --omega 8"};
  for (const std::string& member : members) call_limited(member, 1);
}

TEST(TimeLimit, SaysInJsonWhatIsNotComplete) {
  const Outcome threshold = call_limited("threshold" + scene +
                                             " --set window.revolutions=20000 --allow 1000000000 "
                                             "--format json",
                                         1);
  const auto json = ordered_json::parse(threshold.out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_GT(json["reached"], 0);
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  EXPECT_TRUE(json["threshold"].is_null());
  EXPECT_EQ(json["reason"], "the time limit was reached");
  const auto simulated =
      ordered_json::parse(call_limited("simulate" + scene +
                                           " --set window.revolutions=900000 --omega 8 --format "
                                           "json",
                                       1)
                              .out);
  EXPECT_EQ(simulated["complete"], false);
  EXPECT_EQ(simulated["certain"], false);
  EXPECT_GT(simulated["reached"], 0);
  EXPECT_EQ(simulated["reached"], simulated["end"]["time"]);
  EXPECT_GE(simulated["reached"], simulated["impacts"].back()["time"]);
}

/// What is not known in time is simulated at some speeds, whatever the command and the format.
TEST(TimeLimit, SaysWhatSimulationAloneTellsOfTheRest) {
  for (const std::string command : {"threshold", "regimes"}) {
    const std::string out = call_limited(command + disturbed, 6).out;
    EXPECT_THAT(out, HasSubstr("By simulation alone, not certain")) << command;
    EXPECT_THAT(out, testing::ContainsRegex("\n *18[.]000 +171[.]89 ")) << command;
  }
  const auto json = ordered_json::parse(call_limited("threshold --format json" + disturbed, 6).out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["reached"], 0.01);
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  ASSERT_GT(json["sampled"].size(), 10U);
  EXPECT_EQ(json["sampled"].back()["omega"], 18.0);
  for (const auto& sampled : json["sampled"]) {
    EXPECT_GT(sampled["mean_per_turn"], 0);
    EXPECT_GE(sampled["most_per_turn"], sampled["mean_per_turn"]);
  }
  EXPECT_EQ(call_limited("regimes --format json" + disturbed, 1).out, "[]\n");
  EXPECT_TRUE(ordered_json::parse(call("threshold --format json" + scene).out)["sampled"].empty());
}

/// What comes before and after the main work is under the limit, too, and as large as it may be.
TEST(TimeLimit, IsOfTheWholeCommand) {
  std::string knocks = "time\n";
  for (int k = 1; k <= 200'000; ++k) knocks += fmt::format("{:.6f}\n", 0.02 * k + 0.003 * (k % 7));
  const auto file = write(fresh_folder(), "knocks.csv", knocks);
  call_limited(fmt::format("identify {} --omega 7", file.string()) + scene, 2);
  call_limited("regimes" + scene + " --starts 10000000 --omega 8", 2);
}

TEST(TimeLimit, ShowsProgressAfterASecondAndNoneBefore) {
  EXPECT_THAT(call_limited("regimes" + disturbed, 3).err, HasSubstr("regimes: "));
  EXPECT_THAT(call_limited("regimes --quiet" + disturbed, 3).err, Not(HasSubstr("regimes: ")));
  EXPECT_EQ(call("regimes" + scene).err, "");
}

TEST(TimeLimit, DoesNotChangeWhatIsThereInTime) {
  for (const std::string command :
       {"threshold", "regimes", "simulate --omega 8", "threshold --allow 5"}) {
    const std::string arguments = command + scene + " --format json";
    auto some = ordered_json::parse(call(arguments + " --seconds 1000").out);
    auto all = ordered_json::parse(call(arguments + " --seconds inf").out);
    for (auto* each : {&some, &all}) {
      if (each->is_object()) each->erase("seconds");
    }
    EXPECT_EQ(some, all) << command;
  }
}

TEST(TimeLimit, RefusesNoTime) {
  for (const std::string command : {"threshold", "regimes", "simulate"}) {
    expect_refusal(command + scene + " --seconds 0", "--seconds 0: must be > 0");
    expect_refusal(command + scene + " --seconds nan", "--seconds nan: must be > 0");
  }
}

TEST(Threshold, OfAMachineThatIsLoudEverywhereIsNoNumber) {
  const std::string loud =
      "threshold" + scene + " --set friction=0 --set counting_limit=1e-6 --fastest 5";
  const Outcome text = call(loud);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("loud at every speed up to 5 rad/s"));
  const auto json = ordered_json::parse(call(loud + " --format json").out);
  EXPECT_TRUE(json["threshold"].is_null());
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  EXPECT_EQ(json["reason"], "loud at every speed");
  EXPECT_EQ(json["first_loud"], 0.01);
}

}  // namespace
}  // namespace ricochet::cli
