#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;

std::string temporary(const std::string& name) {
  return (std::filesystem::path(testing::TempDir()) / ("ricochet_regimes_" + name)).string();
}

TEST(Regimes, FollowsBordersOverAConstant) {
  const std::string csv = temporary("borders.csv"), plot = temporary("map.svg");
  const Outcome outcome = call("regimes --case C1 --over restitution=0.05..0.2 --values 4 --csv " +
                               csv + " --plot " + plot);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("C1: borders between regimes over restitution; the machine "
                                     "itself has 0.1."));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\n2 to 4 +counting-limit +15.05 +8.079"));
  EXPECT_THAT(read(csv), HasSubstr("counting-limit,2,3,0.1,8.07905"));
  EXPECT_THAT(read(plot), AllOf(HasSubstr("C1 with other values of the restitution"),
                                HasSubstr("2 collisions a turn"), HasSubstr("C1: 9")));
  std::filesystem::remove(csv);
  std::filesystem::remove(plot);
}

TEST(Regimes, PrintsTheDataOfBorders) {
  const Outcome outcome =
      call("regimes --case C1 --over 'clearance=0.5..2 mm' --values 3 --to 9 --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["machine"], "C1");
  EXPECT_EQ(json["from"], 0.5e-3);
  EXPECT_EQ(json["to"], 2e-3);
  const auto& curve = json["curves"].at(0);
  for (const char* key :
       {"kind", "collisions_slower", "collisions_faster", "own", "begins", "ends", "points"}) {
    EXPECT_TRUE(curve.contains(key)) << key;
  }
  for (const char* key : {"constant", "omega", "slope"}) {
    EXPECT_TRUE(curve["points"].at(0).contains(key)) << key;
  }
}

TEST(Regimes, SaysWhichMotionsStartsLeadTo) {
  const Outcome outcome = call("regimes --case C2 --omega 6 --starts 50 --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = ordered_json::parse(outcome.out);
  EXPECT_EQ(json["omega"], 6);
  ASSERT_EQ(json["motions"].size(), 1U);
  EXPECT_EQ(json["motions"][0]["starts"], 50);
  EXPECT_EQ(json["motions"][0]["share_upper"], 1);
  EXPECT_NEAR(json["motions"][0]["share_lower"].get<double>(), 50 / (50 + 1.96 * 1.96), 1e-3);
  EXPECT_EQ(json["motions"][0]["collisions_per_turn"], 16);
  EXPECT_THAT(call("regimes --case C2 --omega 6 --starts 50").out,
              HasSubstr("C2 at 6 rad/s: 50 starts lead to 1 motion."));
}

/// What docs/paper.md states of the end of two collisions a turn, beside what stands in the report
/// of the paper's cases.
TEST(Regimes, OfTheFirstCaseTakeTheEnergyThatTheDocumentSays) {
  const auto regimes = ordered_json::parse(call("regimes --case C1 --format json").out);
  const auto two = std::ranges::find_if(regimes, [](const ordered_json& regime) {
    return regime["most_per_turn"] == 2 && regime["ends_by"] == "counting-limit";
  });
  ASSERT_NE(two, regimes.end());
  EXPECT_THAT(
      read(RICOCHET_SOURCE "/docs/paper.md"),
      HasSubstr(fmt::format("{:.2f} mJ a turn", 1e3 * (*two)["energy_per_turn"].get<double>())));
}

/// What README and docs/paper.md state of the counting limit.
TEST(Regimes, OfTheFirstCaseMoveWithTheCountingLimitAsTheDocumentsSay) {
  const std::string page = read(RICOCHET_SOURCE "/docs/paper.md");
  const std::string readme = read(RICOCHET_SOURCE "/README.md");
  const auto answer = [](const std::string& settings) {
    return ordered_json::parse(call("threshold --case C1 --format json" + settings).out);
  };
  const ordered_json moves = answer("")["percent_for_one"];
  for (const auto& [key, percent] : moves.items()) {
    const bool leads = key == "counting_limit" || key == "restitution";
    EXPECT_EQ(std::abs(percent.get<double>()) > 0.8, leads) << key;
  }
  for (const char* key : {"counting_limit", "restitution", "clearance"}) {
    const double percent = moves[key];
    EXPECT_THAT(page, HasSubstr(fmt::format("{:+.2f} %", percent))) << key;
    if (key == std::string("clearance")) continue;
    EXPECT_THAT(readme, HasSubstr(fmt::format(" {:.2f} %", percent))) << key;
  }
  for (const auto& [limit, words] :
       {std::pair("1", "1 mm/s that speed is {:.2f} rad/s"), std::pair("10", "10 mm/s {:.2f}. ")}) {
    const double speed =
        answer(fmt::format(" --set 'counting_limit={} mm/s'", limit))["fastest_quiet"];
    EXPECT_THAT(readme, HasSubstr(fmt::format(fmt::runtime(words), speed))) << limit;
  }
}

TEST(Regimes, RefusesWhatItCannotFollow) {
  const auto refuses = [](const std::string& options, const std::string& part) {
    expect_refusal("regimes --case C1 " + options, part);
  };
  refuses("--over restitution", "must be CONSTANT=FROM..TO");
  refuses("--over wall_lower=0..1", "clearance");
  refuses("--over restitution=0.1..1.5", "restitution");
  refuses("--over restitution=0.5..0.1", "must rise");
  refuses("--over restitution=a..b", "must be two numbers");
  refuses("--over 'clearance=1..2 N'", "units m, mm, cm, um");
  refuses("--over restitution=0.1..0.5 --values 1", "values: 1 is not within 2..");
  refuses("--csv x.csv", "--csv requires --over");
  refuses("--omega 6", "--omega requires --starts");
  refuses("--starts 0 --omega 6", "starts 0: must be within 1..");
  refuses("--starts 10 --plot x.svg", "takes no --plot");
}

}  // namespace
}  // namespace ricochet::cli
