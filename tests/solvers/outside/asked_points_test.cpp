#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ricochet/error.h"
#include "solvers/outside/outside.h"

namespace ricochet::outside {
namespace {

using Json = nlohmann::ordered_json;

AskedPoints asked_by(const char* line) {
  return asked_points(Json::parse(line), "x", 2);
}

std::string refusal_of(const char* line) {
  try {
    asked_by(line);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AskedPoints, AreOneOrAList) {
  const AskedPoints one = asked_by(R"({"x": [1, 2]})");
  EXPECT_FALSE(one.list);
  ASSERT_EQ(one.points.size(), 1U);
  EXPECT_EQ(one.points[0], Vector({{1, 2}}));
  const AskedPoints many = asked_by(R"({"x": [[1, 2], [3, 4.5]]})");
  EXPECT_TRUE(many.list);
  ASSERT_EQ(many.points.size(), 2U);
  EXPECT_EQ(many.points[1], Vector({{3, 4.5}}));
  EXPECT_TRUE(asked_by(R"({"x": [[1, 2]]})").list) << "of one point";
  EXPECT_TRUE(std::isnan(asked_by(R"({"x": [1, null]})").points[0][1]));
}

TEST(AskedPoints, SayWhatIsWanted) {
  const AskedPoints both = asked_by(R"({"derivatives": true, "x": [1, 2], "residuals": true})");
  EXPECT_TRUE(both.wanted.derivatives);
  EXPECT_TRUE(both.wanted.residuals);
  const Json bare = Json::parse(R"({"x": [1, 2]})");
  EXPECT_FALSE(asked_points(bare, "x", 2).wanted.derivatives);
  EXPECT_TRUE(asked_points(bare, "x", 2, {.derivatives = true}).wanted.derivatives);
}

TEST(AskedPoints, AreRefusedWithWhatIsWrong) {
  EXPECT_EQ(refusal_of(R"({"x": [1]})"), "x must have 2 numbers");
  EXPECT_EQ(refusal_of(R"({"x": 1})"), "x must have 2 numbers");
  EXPECT_EQ(refusal_of(R"({"x": []})"), "x must have 2 numbers");
  EXPECT_EQ(refusal_of(R"({"x": [1, [2]]})"), "x must have 2 numbers: entry 2 is of type array");
  EXPECT_EQ(refusal_of(R"({"x": [[1, 2], [3]]})"), "x must have 2 numbers in point 2");
  EXPECT_EQ(refusal_of(R"({"x": [[1, 2], ["3", 4]]})"),
            "x must have 2 numbers in point 2: entry 1 is of type string");
  EXPECT_EQ(refusal_of(R"({"x": [1, 2], "residual": true})"),
            "residual is not expected; did you mean residuals?");
  EXPECT_EQ(refusal_of(R"({"x": [1, 2], "residuals": 1})"), "residuals must be true or false");
}

TEST(AskedPoints, AreAnsweredKeyByKey) {
  const Json first = {{"objective", 1}, {"gradient", {2, 3}}};
  const Json second = {{"objective", nullptr}, {"gradient", {4, 5}}};
  EXPECT_EQ(joined({first}, false), first);
  EXPECT_EQ(joined({first}, true), Json::parse(R"({"objective": [1], "gradient": [[2, 3]]})"));
  EXPECT_EQ(joined({first, second}, true),
            Json::parse(R"({"objective": [1, null], "gradient": [[2, 3], [4, 5]]})"));
}

}  // namespace
}  // namespace ricochet::outside
