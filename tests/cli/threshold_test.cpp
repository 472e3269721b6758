#include "problems/carrier_track/counting/threshold.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

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
    EXPECT_THAT(keys_of(row),
                testing::ElementsAre("case", "restitution", "friction", "disturbance",
                                     "paper_threshold", "threshold", "first_loud", "misclassified",
                                     "purity", "loudness", "paper_quiet_count", "quiet_count",
                                     "reading", "evaluations", "seconds", "examples"));
  }
  EXPECT_EQ(json[0]["paper_threshold"], 9.0);
  EXPECT_TRUE(json[10]["paper_threshold"].is_null());
  EXPECT_TRUE(json[10]["paper_quiet_count"].is_null());
  EXPECT_GE(json[1]["quiet_count"], 10);
  EXPECT_LE(json[1]["quiet_count"], 13);
  EXPECT_EQ(json[1]["examples"].size(), 2U);
  EXPECT_EQ(json[1]["examples"][0]["side"], "quiet");
}

TEST(Threshold, OfOneSceneIsOneObject) {
  const auto json = ordered_json::parse(call("threshold --case C2 --fastest 3 --format json").out);
  EXPECT_EQ(json["case"], "C2");
  const carrier_track::Case the_case = carrier_track::find_case("C2");
  const carrier_track::Score expected =
      score(scene_of(the_case, carrier_track::default_reading().scene), the_case.claim,
            carrier_track::ScanOptions{1e-3, 10, 3.0});
  EXPECT_NEAR(json["threshold"], *expected.threshold, 1e-9);
  EXPECT_NEAR(json["first_loud"], *expected.first_loud, 1e-9);
}

TEST(Threshold, TellsAnEngineerWhereToStay) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("scene --case C2").out);
  const Outcome outcome = call("threshold --fastest 5 --scene " + file.string());
  EXPECT_EQ(outcome.exit_code, 0);
  const auto json = ordered_json::parse(call("threshold --case C2 --fastest 5 --format json").out);
  const double first_loud = json["first_loud"];
  EXPECT_THAT(outcome.out, HasSubstr(fmt::format("machine: stay below {:.3f} rad/s", first_loud)));
  EXPECT_EQ(outcome.out.find("paper"), std::string::npos);
}

TEST(Threshold, RefusesRangesAndCombinationsThatMakeNoSense) {
  expect_refusal("threshold --case C1 --fastest 0", "--fastest");
  expect_refusal("threshold --case C1 --fastest nan", "--fastest");
  expect_refusal("threshold --all --case C1", "--all");
  expect_refusal("threshold", "--case");
}

}  // namespace
}  // namespace ricochet::cli
