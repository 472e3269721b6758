#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/machine/regime_tables.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Json;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

const RegimeMap& table_map() {
  static const RegimeMap map = regime_map(scene_of(find_case("C1"), default_machine()),
                                          {{"restitution", 0.05, 0.95}, 13, {"omega", 0.5, 12}});
  return map;
}

TEST(RegimeCurveTable, HasARowForEachBorderOfTheMachine) {
  const std::string text = text_of(table_map(), {});
  EXPECT_THAT(text, HasSubstr("Their speeds [rad/s] at values of restitution:\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\n2 to 4 +counting-limit +4.736 +3.288"));
  EXPECT_THAT(text, testing::ContainsRegex("\n2 to 4 .* speeds +range\n"));
}

TEST(RegimeCurveTable, HasEveryPointInItsData) {
  const RegimeMap& map = table_map();
  const Json json = json_of(map);
  EXPECT_EQ(json["constant"], "restitution");
  EXPECT_EQ(json["own"], 0.1);
  EXPECT_EQ(json["followed"], true);
  ASSERT_EQ(json["curves"].size(), map.curves.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const Json& curve = json["curves"][i];
    EXPECT_EQ(curve["kind"], name_of(*map.curves[i].kind));
    EXPECT_EQ(curve["ends"], name_of(map.curves[i].ends));
    ASSERT_EQ(curve["points"].size(), map.curves[i].points.size());
    EXPECT_EQ(curve["points"][0]["slope"], *map.curves[i].points[0].slope);
    points += curve["points"].size();
  }
  ASSERT_EQ(json["columns"].size(), map.columns.size());
  EXPECT_EQ(json["columns"][3]["cells"][60], *map.columns[3].cells[60]);
  EXPECT_EQ(json["heights"].size(), map.columns[3].cells.size());
  const std::string csv = csv_of(point_table(map));
  EXPECT_THAT(csv, testing::StartsWith(
                       "curve,kind,collisions_slower,collisions_faster,constant,omega,slope\n"));
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), points + 1);
}

TEST(RegimeCurveTable, HasTheLevelsOfDisturbedMachines) {
  const RegimeMap map = regime_map(scene_of(find_case("C5"), default_machine()),
                                   {{"restitution", 0.1, 0.2}, 2, {"omega", 1, 4}});
  EXPECT_THAT(text_of(map, {}),
              HasSubstr("The lowest speed [rad/s] at which the collisions change so, to 0.01"));
  EXPECT_EQ(json_of(map)["curves"][0]["kind"], nullptr);
}

}  // namespace
}  // namespace ricochet::studies::advice
