#include "problems/carrier_track/counting/threshold.h"

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/app/tool.h"

/// Commands that go through the speeds of a machine: answers, limits of time, and what is known
/// when such a limit is reached.
namespace ricochet::cli {
namespace {

using testing::ContainsRegex;

TEST(Threshold, OfOneSceneIsOneObject) {
  const Json json = json_of("threshold --case C2 --fastest 3");
  EXPECT_EQ(json["case"], "C2");
  const carrier_track::Case the_case = carrier_track::find_case("C2");
  const carrier_track::Score expected =
      score(scene_of(the_case, carrier_track::default_machine()), the_case.claim,
            carrier_track::ScanOptions{1e-3, 10, 3.0});
  EXPECT_NEAR(json["threshold"], *expected.threshold, 1e-9);
  EXPECT_NEAR(json["first_loud"], *expected.first_loud, 1e-9);
  EXPECT_EQ(json["misclassified"], expected.misclassified);
  EXPECT_EQ(json["evaluations"], expected.evaluations);
  EXPECT_GT(json["seconds"], 0);
}

TEST(Threshold, IsOneForACaseAndItsFileWithThePapersRuleBesideIt) {
  for (const std::string id : {"C1", "C2", "C4", "C5"}) {
    const double first_loud = json_of("threshold --case " + id)["first_loud"];
    write(id + ".toml", out_of("scene --case " + id));
    const std::string of_case = out_of("threshold --case " + id);
    const std::string of_file = out_of("threshold --scene {}.toml", id);
    EXPECT_THAT(of_case, StartsWith(of_file));
    EXPECT_THAT(of_case.substr(of_file.size()),
                StartsWith("By the paper's rule, for a window of 1.38 turns after a fitted "
                           "start: the lowest loud speed is " +
                           fmt::format("{:.3f} rad/s ({:.2f} rpm)", first_loud,
                                       first_loud * 30 / std::numbers::pi)));
  }
}

const std::string scene = " --scene " RICOCHET_SOURCE "/examples/machine.toml";

TEST(Threshold, KeepsALimit) {
  const auto at = [](const std::string& limit) { return json_of("threshold --case C1 " + limit); };
  using namespace carrier_track;
  const Scene c1 = scene_of(find_case("C1"), default_machine());
  const SpeedScan scan = scan_speeds(c1, 1e-3, 18);
  const double quiet = best_split(scan, 6).first_loud.value() - scan.step;
  EXPECT_NEAR(at("--allow 6")["fastest_quiet"], quiet, 1e-9);
  const Json per_turn = at("--allow-per-turn 2");
  EXPECT_EQ(per_turn["limit"]["measure"], "collisions_per_turn");
  EXPECT_EQ(per_turn["fastest_quiet"], at("")["fastest_quiet"]);
  EXPECT_TRUE(at("--allow-speed 0")["fastest_quiet"].is_null());
  const Json uncertain = at("--allow 6 --tolerance 5")["with_tolerance"];
  EXPECT_LT(uncertain["lowest"], 0.97 * quiet);
  EXPECT_GT(uncertain["highest"], 1.02 * quiet);
}

/// A disturbance above friction: hours without a limit.
const std::string disturbed = scene + " --set disturbance=3 --set disturbance_frequency=7.3";
const std::string long_window = scene + " --set window.revolutions=20000";

/// Calls a command that must end soon after its limit, with exit code 1 and a reason.
Outcome call_limited(const std::string& arguments, int seconds) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = call("{} --seconds {}", arguments, seconds);
  EXPECT_EQ(outcome.exit_code, 1) << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(fmt::format("the time limit of {} s", seconds))) << arguments;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(seconds + 20))
      << arguments;
  return outcome;
}

/// What comes before and after the main work is under the limit, too, and as large as it may be.
TEST(TimeLimit, EndsEveryCommandThatComputesAMachine) {
  std::string knocks = "time\n";
  for (int k = 1; k <= 200'000; ++k) knocks += fmt::format("{:.6f}\n", 0.02 * k + 0.003 * (k % 7));
  write("knocks.csv", knocks);
  for (const std::string& arguments :
       {"regimes" + disturbed + " --over clearance=0.0005..0.001",
        "threshold" + scene +
            " --set disturbance=5 --set disturbance_frequency=31 --allow-per-turn 100000",
        "threshold" + long_window + " --allow-energy 1e9",
        "regimes" + scene + " --starts 10000000 --omega 8",
        "identify knocks.csv --omega 7" + scene}) {
    call_limited(arguments, 1);
  }
}

TEST(TimeLimit, SaysInJsonWhatIsNotComplete) {
  const Json json = Json::parse(
      call_limited("threshold" + long_window + " --allow 1000000000 --format json", 1).out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_GT(json["reached"], 0);
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  EXPECT_TRUE(json["threshold"].is_null());
  EXPECT_EQ(json["reason"], "the time limit was reached");
  const Json simulated = Json::parse(
      call_limited("simulate --set window.revolutions=900000 --omega 8 --format json" + scene, 1)
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
    EXPECT_THAT(call_limited(command + disturbed, 6).out,
                AllOf(HasSubstr("By simulation alone, not certain"),
                      ContainsRegex("\n *18[.]000 +171[.]89 ")))
        << command;
  }
  const Json json = Json::parse(call_limited("threshold --format json" + disturbed, 6).out);
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
  EXPECT_TRUE(json_of("threshold" + scene)["sampled"].empty());
}

TEST(TimeLimit, ShowsProgressAfterASecondAndNoneBefore) {
  EXPECT_THAT(call_limited("regimes" + disturbed, 3).err, HasSubstr("regimes: "));
  EXPECT_THAT(call_limited("regimes --quiet" + disturbed, 3).err, Not(HasSubstr("regimes: ")));
  EXPECT_EQ(call("regimes" + scene).err, "");
}

TEST(TimeLimit, DoesNotChangeWhatIsThereInTime) {
  for (const std::string command :
       {"threshold", "regimes", "simulate --omega 8", "threshold --allow 5"}) {
    Json some = json_of(command + scene + " --seconds 1000");
    Json all = json_of(command + scene + " --seconds inf");
    for (Json* each : {&some, &all}) {
      if (each->is_object()) each->erase("seconds");
    }
    EXPECT_EQ(some, all) << command;
  }
}

}  // namespace
}  // namespace ricochet::cli
