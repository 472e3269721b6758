#include "src/studies/machine/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::studies {
namespace {

using namespace carrier_track;

report::Json data_for(const Scene& scene, const QuietSpeedOptions& options) {
  report::Json data = advice_study({"mine", scene, options, 0}).compute(false);
  data["report"] = "advice";
  return data;
}

Scene case_scene(const char* id) {
  return scene_of(find_case(id), default_machine());
}

/// What is asked of C1 by default: it takes ten seconds.
const report::Json& data_of_c1() {
  static const report::Json data = data_for(case_scene("C1"), {});
  return data;
}

TEST(AdviceStudy, DrawsTheStaircaseWhereItIs) {
  const Scene scene = case_scene("C1");
  const report::Json data = data_for(scene, {Limit{Measure::collisions, 6}, 1e-3, 18});
  ASSERT_GT(data["staircase"].size(), 3U);
  for (const report::Json& row : data["staircase"]) {
    const double speed = row["speed"];
    EXPECT_LE(speed, 18);
    EXPECT_EQ(row["count"], count_at(scene, speed));
  }
  for (const report::Json& row : data["wear"]) {
    EXPECT_EQ(row["energy"],
              1e3 * measured(at_speed(scene, row["speed"].get<double>()), Measure::energy));
  }
}

TEST(AdviceStudy, DrawsTheLongRunUnlessTheWindowIsLimited) {
  const Scene scene = case_scene("C1");
  const report::Json& data = data_of_c1();
  EXPECT_EQ(data["when"], "a turn, in the long run");
  const auto regimes = regimes_of(scene);
  ASSERT_EQ(data["staircase"].size(), regimes.size() + 1);
  ASSERT_EQ(data["regimes"].size(), regimes.size());
  ASSERT_EQ(data["regime_rows"].size(), 4U);
  EXPECT_EQ(data["regime_rows"][2]["collisions"], "2");
  EXPECT_EQ(data["regime_rows"][2]["to"], regimes[3].to);
  EXPECT_EQ(data["regime_rows"][2]["energy"], 1e3 * regimes[3].last.energy_per_turn);
  EXPECT_EQ(data["regime_rows"][2]["impact"], 1e3 * regimes[3].last.fastest_impact);
  ASSERT_EQ(data["wear"].size(), 2 * regimes.size());
  EXPECT_EQ(data["wear"][7]["energy"], 1e3 * regimes[3].last.energy_per_turn);
}

TEST(AdviceStudy, ShowsThePathsBelowAndAbove) {
  const report::Json& data = data_of_c1();
  ASSERT_EQ(data["paths"].size(), 2U);
  for (const report::Json& path : data["paths"]) {
    EXPECT_EQ(path["counted"].size(), path["count"]) << path["side"];
  }
  EXPECT_LT(data["paths"][0]["count"], data["paths"][1]["count"]);
  EXPECT_LT(data["paths"][0]["omega"], data["paths"][1]["omega"]);
}

TEST(AdviceStudy, MarksTheMaximaWhereTheseCount) {
  Scene scene = case_scene("C1");
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.9 * scene.wall_upper;
  scene.peak_low = 0.1 * scene.wall_upper;
  const report::Json data = data_for(scene, {Limit{Measure::collisions, 6}, 1e-2, 12});
  ASSERT_EQ(data["paths"].size(), 2U);
  for (const report::Json& path : data["paths"]) {
    EXPECT_EQ(path["counted"].size(), path["count"]) << path["side"];
    EXPECT_EQ(path["what_counts"], "maximum that counts");
  }
}

TEST(AdviceStudy, FillsItsTemplateWhateverTheAnswer) {
  const std::string page_template = report::page_template("advice");
  Scene slip = case_scene("C3");
  slip.wall_upper = 0.8;
  slip.window = Seconds{1};
  const report::Json doubtful = data_for(slip, {std::nullopt, 1e-2, 5});
  for (const report::Json& data :
       {data_of_c1(), data_for(case_scene("C3"), {Limit{Measure::collisions, 99}, 1e-2, 4}),
        data_for(case_scene("C3"), {Limit{Measure::collisions, 0}, 1e-2, 4}), doubtful}) {
    const report::DrawnPage drawing = report::drawn(page_template, data);
    EXPECT_EQ(drawing.page.title, "How fast may mine turn?");
    EXPECT_THAT(drawing.epilogue, testing::StartsWith("mine: "));
  }
  EXPECT_THAT(doubtful["doubts"].dump(), testing::HasSubstr("0.8 m: walls so far apart"));
}

}  // namespace
}  // namespace ricochet::studies
