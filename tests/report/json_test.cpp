#include "src/report/json.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet::report {
namespace {

struct Piece {
  double number;
  std::vector<double> numbers = {};
};
RICOCHET_FIELDS(Piece, number, numbers);

struct Whole {
  std::string case_;
  std::optional<int> count;
  std::vector<Piece> parts;
};
RICOCHET_FIELDS(Whole, case_, count, parts);

TEST(StructAsJson, HasItsMembersInOrder) {
  const Json json = Whole{"C1", 3, {{0.5}}};
  EXPECT_EQ(json.dump(), R"({"case":"C1","count":3,"parts":[{"number":0.5,"numbers":[]}]})");
}

TEST(StructAsJson, HasNullForWhatIsMissingOrNotFinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Json json = Whole{"C1", {}, {{infinite, {1, -infinite}}}};
  EXPECT_TRUE(json["count"].is_null());
  EXPECT_TRUE(json["parts"][0]["number"].is_null());
  EXPECT_EQ(json["parts"][0]["numbers"], (Json{1.0, nullptr}));
}

TEST(StructAsJson, IsReadBack) {
  const Json json = Whole{"C1", 3, {{0.5, {1, 2}}}};
  EXPECT_EQ(Json(json.get<Whole>()), json);
  const Json without = Whole{"C1", {}, {}};
  EXPECT_FALSE(without.get<Whole>().count);
}

TEST(StructAsJson, IsNotReadFromAnotherVersion) {
  Json json = Whole{"C1", 3, {}};
  json.erase("parts");
  EXPECT_THROW(json.get<Whole>(), Json::exception);
  json["parts"] = 7;
  EXPECT_THROW(json.get<Whole>(), Json::exception);
  json["parts"] = Json::array();
  json.erase("count");  // the same as null
  EXPECT_FALSE(json.get<Whole>().count);
}

}  // namespace
}  // namespace ricochet::report
