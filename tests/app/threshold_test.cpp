#include "problems/carrier_track/counting/threshold.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(Threshold, PrintsTheJsonOfTheContractForEveryCase) {
  const Outcome outcome = call("threshold --all --fastest 3 --format json");
  ASSERT_EQ(outcome.exit_code, 0);
  const auto json = ordered_json::parse(outcome.out);
  ASSERT_EQ(json.size(), 12U);
  for (const auto& row : json) {
    EXPECT_THAT(
        keys_of(row),
        testing::ElementsAre("case", "restitution", "friction", "disturbance", "paper_threshold",
                             "threshold", "first_loud", "misclassified", "purity", "loudness",
                             "paper_quiet_count", "quiet_count", "interpretation", "evaluations",
                             "seconds", "complete", "examples"));
  }
  EXPECT_EQ(json[0]["paper_threshold"], 9.0);
  EXPECT_TRUE(json[10]["paper_threshold"].is_null());
  EXPECT_TRUE(json[10]["paper_quiet_count"].is_null());
  EXPECT_GE(json[1]["quiet_count"], 10);
  EXPECT_LE(json[1]["quiet_count"], 13);
  EXPECT_EQ(json[1]["examples"].size(), 2U);
  EXPECT_EQ(json[1]["examples"][0]["side"], "quiet");
}

TEST(Threshold, PrintsARowForEveryCase) {
  const std::string out = call("threshold --all --fastest 3").out;
  const auto json = ordered_json::parse(call("threshold --all --fastest 3 --format json").out);
  for (const auto& row : json) {
    const std::string threshold =
        row["threshold"].is_null() ? "" : fmt::format("{:.4f}", row["threshold"].get<double>());
    EXPECT_THAT(out, testing::ContainsRegex(
                         fmt::format("\n{} +{} ", row["case"].get<std::string>(), threshold)));
  }
}

TEST(Threshold, OfOneSceneIsOneObject) {
  const auto json = ordered_json::parse(call("threshold --case C2 --fastest 3 --format json").out);
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
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C1").out).string();
  const Outcome outcome = call("threshold --scene " + file);
  EXPECT_EQ(outcome.exit_code, 0);
  const auto json = ordered_json::parse(call("threshold --format json --scene " + file).out);
  EXPECT_THAT(outcome.out, HasSubstr("machine: the fastest quiet speed is " +
                                     in_both_units(json["fastest_quiet"])));
  EXPECT_THAT(outcome.out, HasSubstr("In the long run: silent up to "));
  ASSERT_GT(json["regimes"].size(), 3U);
  EXPECT_LT(json["fastest_quiet"], json["first_loud"]);
  EXPECT_THAT(outcome.out, HasSubstr("One percent more moves this speed by:"));
  EXPECT_EQ(outcome.out.find("paper"), std::string::npos);
  const std::string window = call("threshold --allow 3 --scene " + file).out;
  const auto steps =
      ordered_json::parse(call("threshold --allow 3 --format json --scene " + file).out)["steps"];
  ASSERT_EQ(steps.size(), 2U);
  // Midway between two speeds a millirad/s apart, whose last digit may be rounded either way.
  for (const double step : {steps[0]["omega"], steps[1]["omega"]}) {
    EXPECT_THAT(window,
                testing::AnyOf(testing::ContainsRegex(fmt::format("\n *{:.3f} ", step - 1e-9)),
                               testing::ContainsRegex(fmt::format("\n *{:.3f} ", step + 1e-9))));
  }
  const std::string first_line = outcome.out.substr(0, outcome.out.find('\n'));
  for (const char* fastest : {"14", "30", "60"}) {
    EXPECT_THAT(call(fmt::format("threshold --scene {} --fastest {}", file, fastest)).out,
                testing::StartsWith(first_line));
  }
}

TEST(Threshold, IsOneForACaseAndItsFileWithThePapersRuleBesideIt) {
  const auto folder = fresh_folder();
  for (const char* id : {"C1", "C2", "C4", "C5"}) {
    const std::string of_case = call(fmt::format("threshold --case {}", id)).out;
    const std::string name = fmt::format("{}.toml", id);
    const auto file = write(folder, name, call(fmt::format("scene --case {}", id)).out).string();
    const std::string of_file = call("threshold --scene " + file).out;
    EXPECT_THAT(of_case, testing::StartsWith(of_file));
    const auto json =
        ordered_json::parse(call(fmt::format("threshold --case {} --format json", id)).out);
    EXPECT_THAT(
        of_case.substr(of_file.size()),
        testing::StartsWith("By the paper's rule, for a window of 1.38 turns after a fitted "
                            "start: the lowest loud speed is " +
                            in_both_units(json["first_loud"])));
  }
}

TEST(Threshold, SaysThatThereIsNone) {
  const auto folder = fresh_folder();
  // The planar model has no regimes, and the count of this machine rises throughout.
  const std::string across =
      "\n[across]\nwall_lower = 0\nwall_upper = 1\nrestitution = 1\nstart_position = 0.5\n";
  const auto file =
      write(folder, "machine.toml",
            std::regex_replace(
                call("scene --case C2 --set restitution=0.814 --set contact_friction=false").out,
                std::regex("fidelity = \"impact\""), "fidelity = \"planar\"") +
                across)
          .string();
  EXPECT_THAT(call("threshold --scene " + file).out, HasSubstr("machine: there is no threshold"));
  const auto json = ordered_json::parse(call("threshold --format json --scene " + file).out);
  EXPECT_TRUE(json["fastest_quiet"].is_null());
  EXPECT_TRUE(json["threshold"].is_null());
}

TEST(Threshold, KeepsALimit) {
  const auto at = [](const std::string& limit) {
    return ordered_json::parse(call("threshold --case C1 --format json " + limit).out);
  };
  using namespace carrier_track;
  const Scene scene = scene_of(find_case("C1"), default_machine());
  const SpeedScan scan = scan_speeds(scene, 1e-3, 18);
  const double quiet = best_split(scan, 6).first_loud.value() - scan.step;
  EXPECT_NEAR(at("--allow 6")["fastest_quiet"], quiet, 1e-9);
  const auto per_turn = at("--allow-per-turn 2");
  EXPECT_EQ(per_turn["limit"]["measure"], "collisions_per_turn");
  EXPECT_EQ(per_turn["fastest_quiet"], at("")["fastest_quiet"]);
  EXPECT_TRUE(at("--allow-speed 0")["fastest_quiet"].is_null());
  const auto uncertain = at("--allow 6 --tolerance 5")["with_tolerance"];
  EXPECT_LT(uncertain["lowest"], 0.97 * quiet);
  EXPECT_GT(uncertain["highest"], 1.02 * quiet);
}

TEST(Threshold, OfACaseWithSettingsIsThatOfAMachine) {
  const auto json = ordered_json::parse(
      call("threshold --case C1 --set restitution=0.2 --fastest 6 --format json").out);
  EXPECT_EQ(json["case"], "C1 with restitution=0.2");
  EXPECT_EQ(json["interpretation"], "own");
  EXPECT_TRUE(json["paper_threshold"].is_null());
  const auto file = write(fresh_folder(), "machine.toml", call("scene --case C1").out).string();
  EXPECT_EQ(json["fastest_quiet"],
            ordered_json::parse(call("threshold --scene " + file +
                                     " --set restitution=0.2 --fastest 6 --format json")
                                    .out)["fastest_quiet"]);
}

TEST(Threshold, IsAnIntervalIfNumbersAreUncertain) {
  const std::string scene =
      "threshold --scene " RICOCHET_SOURCE "/examples/machine.toml --fastest 8";
  EXPECT_TRUE(
      ordered_json::parse(call(scene + " --format json").out)["with_uncertainties"].is_null());
  const std::string uncertain = scene + " --set 'friction={value=0.2, plus_minus=0.02}'";
  const auto json = ordered_json::parse(call(uncertain + " --format json").out);
  const auto& interval = json["with_uncertainties"];
  EXPECT_EQ(interval["machines"], 200);
  EXPECT_LT(interval["lowest"], json["threshold"].get<double>() - 0.1);
  EXPECT_GT(interval["highest"], json["threshold"].get<double>() + 0.1);
  EXPECT_GT(interval["effects"]["scene.friction"], 0.1);
  EXPECT_EQ(interval["first_order"], interval["effects"]["scene.friction"]);
  EXPECT_THAT(call(uncertain).out,
              HasSubstr("With the uncertainties of the file, each uniform within its plus_minus, "
                        "200 machines divide between " +
                        in_both_units(interval["lowest"])));
}

TEST(Threshold, RefusesRangesAndCombinationsThatMakeNoSense) {
  expect_refusal("threshold --case C1 --fastest 0", "--fastest");
  expect_refusal("threshold --case C1 --fastest nan", "--fastest");
  expect_refusal("threshold --all --case C1", "--all");
  expect_refusal("threshold --all --set friction=1", "--set");
  expect_refusal("threshold", "--case");
  expect_refusal("threshold --case C1 --scene f", "only one of --case and --scene");
  expect_refusal("threshold --all --allow 3", "--all");
  expect_refusal("threshold --case C1 --allow 3 --allow-speed 1", "--allow-speed");
  expect_refusal("threshold --case C1 --allow -1", "-1");
  expect_refusal("threshold --case C1 --tolerance 60", "--tolerance");
  expect_refusal("threshold --all --plot steps.svg", "--plot");
}

TEST(Threshold, DrawsTheStaircase) {
  const auto folder = fresh_folder();
  const std::string svg = (folder / "steps.svg").string();
  const Outcome of_case = call("threshold --case C1 --plot " + svg);
  EXPECT_EQ(of_case.exit_code, 0) << of_case.err;
  EXPECT_EQ(of_case.out, call("threshold --case C1").out);
  EXPECT_THAT(read(svg),
              testing::AllOf(testing::StartsWith("<svg"), HasSubstr("C1: collisions against speed"),
                             HasSubstr(">fastest quiet speed</text>"),
                             HasSubstr(">paper's threshold</text>")));
  const auto file = write(folder, "machine.toml", call("scene --case C1").out);
  EXPECT_EQ(call("threshold --allow 3 --scene " + file.string() + " --plot " + svg).exit_code, 0);
  EXPECT_THAT(read(svg), testing::AllOf(HasSubstr(">fastest quiet speed</text>"),
                                        HasSubstr(">step</text>"), Not(HasSubstr("paper"))));
}

TEST(Threshold, NeverDrawsOverItsInput) {
  const auto folder = fresh_folder();
  const std::string text = call("scene --case C1").out;
  const auto scene = write(folder, "machine.toml", text);
  std::filesystem::create_symlink(scene, folder / "link");
  for (const char* name : {"machine.toml", "link"}) {
    expect_refusal("threshold --scene " + scene.string() + " --plot " + (folder / name).string(),
                   "the input");
  }
  EXPECT_EQ(read(scene), text);
  expect_refusal("threshold --case C1 --fastest 2 --plot " + (scene / "steps.svg").string(),
                 "steps.svg");
}

}  // namespace
}  // namespace ricochet::cli
