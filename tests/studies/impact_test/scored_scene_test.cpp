#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "problems/carrier_track/scene/scene_check.h"
#include "src/studies/impact_test/scene_kinds.h"
#include "src/studies/impact_test/smallest_scene.h"

namespace ricochet::studies::impact_test {
namespace {

TEST(ScoredScene, IsDrawnAgainToTheLastBit) {
  for (const int index : {0, 8, 21}) {
    EXPECT_EQ(json_of(drawn_scene(1, index)).dump(), json_of(drawn_scene(1, index)).dump());
    EXPECT_NE(json_of(drawn_scene(2, index)).dump(), json_of(drawn_scene(1, index)).dump());
  }
}

TEST(ScoredScene, IsWrittenAndReadBack) {
  for (int index = 0; index < 22; ++index) {
    const report::Json line = json_of(drawn_scene(1, index));
    EXPECT_EQ(json_of(scored_scene_of(report::Json::parse(line.dump()))), line);
  }
}

TEST(ScoredScene, HasTheKeysOfTheSchema) {
  std::ifstream file(RICOCHET_SOURCE "/docs/impact-test.schema.json");
  const report::Json schema = report::Json::parse(file)["$defs"]["scene"];
  const report::Json line = json_of(drawn_scene(1, 0));
  std::set<std::string> described, written;
  for (const auto& [key, value] : schema["properties"].items()) described.insert(key);
  for (const auto& [key, value] : line.items()) written.insert(key);
  EXPECT_EQ(described, written);
  EXPECT_EQ(schema["properties"]["version"]["const"], suite_version);
  for (const auto& key : schema["required"]) EXPECT_TRUE(line.contains(key.get<std::string>()));
}

TEST(ScoredScene, IsOfEachKindAndDifficultyInTurn) {
  std::set<std::pair<std::string, int>> seen;
  for (int index = 0; index < 44; ++index) {
    const ScoredScene drawn = drawn_scene(4, index);
    seen.insert({drawn.scene.kind, drawn.scene.difficulty});
    carrier_track::check(drawn.machine, drawn.scene.scene);
    EXPECT_GE(scored_impacts(drawn.scene, drawn.truth), 1);
    EXPECT_LE(scored_impacts(drawn.scene, drawn.truth), most_impacts);
    EXPECT_GE(drawn.scene.slowest, least_slowest);
    for (const TrueImpact& i : drawn.truth) {
      EXPECT_LE(i.time_sensitivity, 2 * most_growth * mean_time_between(drawn.scene, drawn.truth));
      EXPECT_LT(i.time, drawn.scene.duration);
    }
  }
  EXPECT_EQ(seen.size(), scene_kinds().size() * difficulties);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
