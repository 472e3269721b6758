#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <nlohmann/json.hpp>

#include "src/report/results.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

TEST(Verify, FindsNoCertainCountWrong) {
  const Outcome outcome = call("verify --scenes 200 --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto results = report::results_in(report::Json::parse(outcome.out));
  const Table& scenes = *results.table("scenes");
  const Row all = scenes[scenes.rows.size() - 1];
  EXPECT_EQ(all.text("scenes"), "all");
  EXPECT_EQ(all.number("number"), 200);
  EXPECT_EQ(all.number("wrong_certain"), 0);
  EXPECT_GT(all.number("certain"), 0.8);  // three of the thirteen kinds are open by design
  EXPECT_GT(all.number("matched"), 700);
  EXPECT_LT(all.number("time_error"), 1e-5);
  EXPECT_TRUE(is_missing(*results.value("wrong")));
  const Table& speeds = *results.table("quiet-speeds");
  ASSERT_EQ(speeds.rows.size(), 12U);
  each_row(speeds, [](const Row& quiet) {
    EXPECT_GT(quiet.number("speeds"), 100);
    EXPECT_GT(quiet.number("compared"), 10);
    EXPECT_GT(quiet.number("certain"), 0.99);
    EXPECT_EQ(quiet.number("wrong_certain"), 0);
  });
}

TEST(Verify, ShowsOneSceneWithBothListsOfImpacts) {
  const auto json = ordered_json::parse(call("verify --scene-index 1 --format json").out);
  EXPECT_EQ(json["hostility"], "graze");
  EXPECT_EQ(json["count"], json["oracle_count"]);
  EXPECT_FALSE(json["impacts"].empty());
  EXPECT_FALSE(json["oracle_impacts"].empty());
  // Its text is a scene that simulate takes.
  const Outcome shown = call("verify --scene-index 1");
  EXPECT_THAT(shown.out, HasSubstr("impacts of the oracle"));
  const auto file = write(fresh_folder(), "scene.toml", shown.out);
  const auto run = ordered_json::parse(call("simulate --format json --scene " + file.string()).out);
  EXPECT_EQ(run["count"], json["count"]);
}

TEST(Verify, RefusesNumbersThatMakeNoSense) {
  expect_refusal("verify --scenes 0", "--scenes");
  expect_refusal("verify --scene-index -1", "--scene-index");
}

TEST(Verify, TellsOfTheCoresThatItMayUse) {
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);  // the program inherits it
  const auto folder = fresh_folder();
  call("verify --scenes 1 --out " + folder.string());
  sched_setaffinity(0, sizeof all, &all);
  EXPECT_THAT(read(folder / "data.json"), testing::HasSubstr("\"threads\":1,"));
}

}  // namespace
}  // namespace ricochet::cli
