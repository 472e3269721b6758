#include "problems/carrier_track/counting/threshold.h"

#include <regex>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/app/tool.h"
#include "tests/support/test.h"

/// Commands that go through the speeds of a machine: answers, limits of time, and what is known
/// when such a limit is reached.
namespace ricochet::cli {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

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

/// A speed as the answers have it.
std::string in_both_units(double speed) {
  return fmt::format("{:.3f} rad/s ({:.2f} rpm)", speed, speed * 30 / std::numbers::pi);
}

TEST(Threshold, TellsAnEngineerWhereToStay) {
  write("machine.toml", out_of("scene --case C1"));
  const std::string threshold = "threshold --scene machine.toml";
  const std::string out = out_of(threshold);
  const Json json = json_of(threshold);
  EXPECT_THAT(out,
              AllOf(HasSubstr("machine: the fastest quiet speed is " +
                              in_both_units(json["fastest_quiet"])),
                    HasSubstr("In the long run: silent up to "),
                    HasSubstr("One percent more moves this speed by:"), Not(HasSubstr("paper"))));
  ASSERT_GT(json["regimes"].size(), 3U);
  EXPECT_LT(json["fastest_quiet"], json["first_loud"]);
  const std::string window = out_of(threshold + " --allow 3");
  const Json steps = json_of(threshold + " --allow 3")["steps"];
  ASSERT_EQ(steps.size(), 2U);
  // Midway between two speeds a millirad/s apart, whose last digit may be rounded either way.
  for (const double step : {steps[0]["omega"], steps[1]["omega"]}) {
    EXPECT_THAT(window, testing::AnyOf(ContainsRegex(fmt::format("\n *{:.3f} ", step - 1e-9)),
                                       ContainsRegex(fmt::format("\n *{:.3f} ", step + 1e-9))));
  }
  for (const char* fastest : {"14", "30", "60"}) {
    EXPECT_THAT(out_of("{} --fastest {}", threshold, fastest),
                StartsWith(out.substr(0, out.find('\n'))));
  }
}

TEST(Threshold, IsOneForACaseAndItsFileWithThePapersRuleBesideIt) {
  for (const std::string id : {"C1", "C2", "C4", "C5"}) {
    write(id + ".toml", out_of("scene --case " + id));
    const std::string of_case = out_of("threshold --case " + id);
    const std::string of_file = out_of("threshold --scene {}.toml", id);
    EXPECT_THAT(of_case, StartsWith(of_file));
    EXPECT_THAT(of_case.substr(of_file.size()),
                StartsWith("By the paper's rule, for a window of 1.38 turns after a fitted "
                           "start: the lowest loud speed is " +
                           in_both_units(json_of("threshold --case " + id)["first_loud"])));
  }
  const std::string settings = " --set restitution=0.2 --fastest 6";
  const Json changed = json_of("threshold --case C1" + settings);
  EXPECT_EQ(changed["case"], "C1 with restitution=0.2");
  EXPECT_EQ(changed["interpretation"], "own");
  EXPECT_TRUE(changed["paper_threshold"].is_null());
  EXPECT_EQ(changed["fastest_quiet"],
            json_of("threshold --scene C1.toml" + settings)["fastest_quiet"]);
}

const std::string scene = " --scene " RICOCHET_SOURCE "/examples/machine.toml";

TEST(Threshold, SaysThatThereIsNone) {
  // The planar model has no regimes, and the count of this machine rises throughout.
  const std::string planar = std::regex_replace(
      out_of("scene --case C2 --set restitution=0.814 --set contact_friction=false"),
      std::regex("fidelity = \"impact\""), "fidelity = \"planar\"");
  write("machine.toml", planar +
                            "\n[across]\nwall_lower = 0\nwall_upper = 1\nrestitution = 1\n"
                            "start_position = 0.5\n");
  EXPECT_THAT(out_of("threshold --scene machine.toml"),
              HasSubstr("machine: there is no threshold"));
  const Json json = json_of("threshold --scene machine.toml");
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  EXPECT_TRUE(json["threshold"].is_null());
  // Of a machine that is loud everywhere it is no number.
  const Json loud =
      json_of("threshold" + scene + " --set friction=0 --set counting_limit=1e-6 --fastest 5");
  EXPECT_TRUE(loud["fastest_quiet"].is_null());
  EXPECT_TRUE(loud["threshold"].is_null());
  EXPECT_EQ(loud["reason"], "loud at every speed");
  EXPECT_EQ(loud["first_loud"], 0.01);
}

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

TEST(Threshold, IsAnIntervalIfNumbersAreUncertain) {
  const std::string threshold = "threshold --fastest 8" + scene;
  EXPECT_TRUE(json_of(threshold)["with_uncertainties"].is_null());
  const std::string uncertain = threshold + " --set 'friction={value=0.2, plus_minus=0.02}'";
  const Json json = json_of(uncertain);
  const auto& interval = json["with_uncertainties"];
  EXPECT_EQ(interval["machines"], 200);
  EXPECT_LT(interval["lowest"], json["threshold"].get<double>() - 0.1);
  EXPECT_GT(interval["highest"], json["threshold"].get<double>() + 0.1);
  EXPECT_GT(interval["effects"]["scene.friction"], 0.1);
  EXPECT_EQ(interval["first_order"], interval["effects"]["scene.friction"]);
  EXPECT_THAT(out_of(uncertain),
              HasSubstr("With the uncertainties of the file, each uniform within its plus_minus, "
                        "200 machines divide between " +
                        in_both_units(interval["lowest"])));
}

/// Numbers that once came out as -nan, or crashed.
TEST(Threshold, ShowsNumbersAtTheEndsOfTheirRanges) {
  write("machine.toml", out_of("machine new"));
  for (const char* setting : {"restitution_upper=0", "restitution_lower=0", "friction=0",
                              "restitution_lower=1", "normal_force=0"}) {
    EXPECT_THAT(call("threshold --scene machine.toml --set {} --seconds 60", setting).out,
                AllOf(Not(HasSubstr("nan")), HasSubstr("restitution ")))
        << setting;
  }
}

TEST(Regimes, SaysWhichMotionsStartsLeadTo) {
  const Json json = json_of("regimes --case C2 --omega 6 --starts 50");
  EXPECT_EQ(json["omega"], 6);
  EXPECT_EQ(json["motions"][0]["share_upper"], 1);
  EXPECT_NEAR(json["motions"][0]["share_lower"].get<double>(), 50 / (50 + 1.96 * 1.96), 1e-3);
  EXPECT_EQ(json["motions"][0]["collisions_per_turn"], 16);
}

/// What README and docs/paper.md state of the first case: its energy, beside what stands in the
/// report of the paper's cases, and how its speed moves with the counting limit.
TEST(Regimes, OfTheFirstCaseAreAsTheDocumentsSay) {
  const std::string page = read(RICOCHET_SOURCE "/docs/paper.md");
  const std::string readme = read(RICOCHET_SOURCE "/README.md");
  const Json regimes = json_of("regimes --case C1");
  const auto two = std::ranges::find_if(regimes, [](const Json& regime) {
    return regime["most_per_turn"] == 2 && regime["ends_by"] == "counting-limit";
  });
  ASSERT_NE(two, regimes.end());
  EXPECT_THAT(page, HasSubstr(fmt::format("{:.2f} mJ a turn",
                                          1e3 * (*two)["energy_per_turn"].get<double>())));
  const auto answer = [](const std::string& settings) {
    return json_of("threshold --case C1" + settings);
  };
  const Json moves = answer("")["percent_for_one"];
  for (const auto& [key, percent] : moves.items()) {
    const bool leads = key == "counting_limit" || key == "restitution";
    EXPECT_EQ(std::abs(percent.get<double>()) > 0.8, leads) << key;
    if (!leads && key != "clearance") continue;
    EXPECT_THAT(page, HasSubstr(fmt::format("{:+.2f} %", percent.get<double>()))) << key;
    if (!leads) continue;
    EXPECT_THAT(readme, HasSubstr(fmt::format(" {:.2f} %", percent.get<double>()))) << key;
  }
  for (const auto& [limit, words] :
       {std::pair("1", "1 mm/s that speed is {:.2f} rad/s"), std::pair("10", "10 mm/s {:.2f}. ")}) {
    const double speed =
        answer(fmt::format(" --set 'counting_limit={} mm/s'", limit))["fastest_quiet"];
    EXPECT_THAT(readme, HasSubstr(fmt::format(fmt::runtime(words), speed))) << limit;
  }
}

/// A disturbance above friction: hours without a limit.
const std::string disturbed = scene + " --set disturbance=3 --set disturbance_frequency=7.3";
const std::string long_window = scene + " --set window.revolutions=20000";
const std::string longer_window = scene + " --set window.revolutions=900000 --omega 8";

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

TEST(TimeLimit, EndsEveryCommandThatComputesAMachine) {
  for (const std::string& arguments :
       {"regimes" + disturbed + " --over clearance=0.0005..0.001",
        "threshold" + scene +
            " --set disturbance=5 --set disturbance_frequency=31 --allow-per-turn 100000",
        "threshold" + long_window + " --allow-energy 1e9",
        "regimes" + scene + " --starts 1000000 --omega 8"}) {
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
  const Json simulated =
      Json::parse(call_limited("simulate" + longer_window + " --format json", 1).out);
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

/// What comes before and after the main work is under the limit, too, and as large as it may be.
TEST(TimeLimit, IsOfTheWholeCommand) {
  std::string knocks = "time\n";
  for (int k = 1; k <= 200'000; ++k) knocks += fmt::format("{:.6f}\n", 0.02 * k + 0.003 * (k % 7));
  write("knocks.csv", knocks);
  call_limited("identify knocks.csv --omega 7" + scene, 2);
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
