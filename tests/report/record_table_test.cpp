#include <gtest/gtest.h>

#include <stdexcept>

#include "src/report/page_template.h"

namespace ricochet::report {
namespace {

TEST(RecordTable, WritesNamesOnce) {
  const Json data = {
      {"cases", {{{"name", "C1"}, {"speed", 9}}, {{"name", "C2"}, {"speed", nullptr}}}}};
  EXPECT_EQ(packed(data).dump(),
            R"({"cases":{"columns":["name","speed"],"rows":[["C1",9],["C2",null]]}})");
  EXPECT_EQ(unpacked(packed(data)), data);
}

TEST(RecordTable, DoesSoAtAllDepths) {
  const Json inner = {{{"x", 1}, {"y", 2}}, {{"x", 3}, {"y", 4}}};
  const Json data = {{{"curve", inner}, {"id", 1}}, {{"curve", inner}, {"id", 2}}};
  EXPECT_EQ(packed(data)["rows"][1][0]["rows"][1], (Json{3, 4}));
  EXPECT_EQ(unpacked(packed(data)).dump(), data.dump());
}

TEST(RecordTable, LeavesListsOfUnlikeThings) {
  for (const char* text :
       {R"([{"a":1},{"b":1}])", R"([{"a":1,"b":2},{"b":2,"a":1}])", R"([{"a":1},2])", R"([{},{}])",
        R"([{"a":1}])", "[[1,2],[3,4]]", "[]", "null", "3"}) {
    const Json data = Json::parse(text);
    EXPECT_EQ(packed(data).dump(), text);
    EXPECT_EQ(unpacked(data).dump(), text);
  }
}

TEST(RecordTable, RefusesWhatCouldNotBeToldFromATable) {
  EXPECT_THROW(packed({{"grid", {{"columns", 3}, {"rows", 4}}}}), std::logic_error);
}

TEST(RecordTable, LeavesTablesThatAreDamaged) {
  for (const char* text : {R"({"columns":["a"],"rows":[[1,2]]})", R"({"columns":["a"],"rows":3})",
                           R"({"columns":[1],"rows":[[1]]})"}) {
    EXPECT_EQ(unpacked(Json::parse(text)).dump(), text);
  }
}

}  // namespace
}  // namespace ricochet::report
