#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "ricochet/scene.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string examples = std::string(RICOCHET_SOURCE) + "/examples";
const std::string arguments = "identify " + examples + "/knocks/knocks.csv --scene " + examples +
                              "/knocks/machine.toml --speed " + examples +
                              "/knocks/speed.csv --marks " + examples + "/knocks/marks.csv";

TEST(Identify, FindsTheMachineOfTheExample) {
  const auto folder = fresh_folder();
  const std::string out = (folder / "fitted.toml").string();
  const std::string svg = (folder / "residuals.svg").string();
  const Outcome outcome = call(arguments + " --format json --out " + out + " --plot " + svg);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const double truths[] = {0.5, 0.2, 0.7e-3};  // of examples/knocks/machine.toml
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& constant = json.at("constants").at(i);
    EXPECT_LE(constant.at("lower"), truths[i]) << constant;
    EXPECT_GE(constant.at("upper"), truths[i]) << constant;
    EXPECT_LT(constant.at("upper").get<double>() / constant.at("lower").get<double>(), 1.2);
  }
  EXPECT_EQ(json.at("complete"), true);
  EXPECT_TRUE(json.at("contradictions").empty());
  EXPECT_GT(json.at("safe_speed").at("value"), 3);
  EXPECT_EQ(json.at("held_fixed").at(0), "mass");
  EXPECT_EQ(json.at("plate").at("marks"), true);
  const auto fitted = carrier_track::read_scene(out);
  EXPECT_EQ(fitted.friction, json.at("constants").at(1).at("value"));
  EXPECT_THAT(read(out), StartsWith("# Restitution, friction and clearance are fitted"));
  EXPECT_THAT(read(svg), AllOf(StartsWith("<svg"), HasSubstr("Recorded minus predicted times")));
}

TEST(Identify, PrintsIntervalsWhatIsHeldAndWhatToRecordNext) {
  const Outcome outcome = call(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("restitution"), HasSubstr("95 %"), HasSubstr("safe speed"),
                    HasSubstr("Record next"), HasSubstr("Held as in the file: mass")));
}

TEST(Identify, HasNoIntervalsWhereTheRecordContradictsWhatIsTakenForGranted) {
  const std::string wrong = arguments + " --mark-angle 0.1 --mark-deviation 0";
  const Outcome outcome = call(wrong);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("The record contradicts the marks"),
                                 HasSubstr("no interval"), Not(HasSubstr("95 %"))));
  const Outcome as_json = call(wrong + " --format json");
  EXPECT_EQ(as_json.exit_code, 1);
  const auto json = nlohmann::json::parse(as_json.out);
  EXPECT_FALSE(json.at("contradictions").empty());
  for (const auto& constant : json.at("constants")) {
    EXPECT_TRUE(constant.at("lower").is_null()) << constant;
    EXPECT_TRUE(constant.at("upper").is_null()) << constant;
  }
}

TEST(Identify, SaysWhereItsTimeLimitEndedIt) {
  const Outcome outcome = call(arguments + " --seconds 0.001");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the time limit of 0.001 s was reached"));
}

TEST(Identify, RefusesBadInput) {
  const std::string knocks = examples + "/knocks/knocks.csv";
  const std::string scene = " --scene " + examples + "/knocks/machine.toml";
  expect_refusal("identify " + knocks + " --omega 3", "--scene");
  expect_refusal("identify " + knocks + scene, "--omega, --speed");
  expect_refusal("identify nowhere.csv --omega 3" + scene, "nowhere.csv");
  expect_refusal(arguments + " --solver nlopt-cobyla", "nlopt-cobyla");
  expect_refusal(arguments + " --fastest 0", "--fastest");
  expect_refusal(arguments + " --out " + knocks, "--out");
  const auto folder = fresh_folder();
  const auto loose = write(folder, "loose.csv", "time\n1\nsoon\n");
  expect_refusal("identify " + loose.string() + " --omega 3" + scene,
                 "loose.csv:3: column time: 'soon'");
}

}  // namespace
}  // namespace ricochet::cli
