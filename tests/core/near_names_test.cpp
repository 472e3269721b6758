#include <gmock/gmock.h>

#include "src/core/names.h"

namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EditDistance, CountsWhatMustBeChanged) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("teh", "the"), 1);
  EXPECT_EQ(edit_distance("Omega", "omega"), 0);
}

TEST(EqualInAnyCase, ComparesLettersAlone) {
  EXPECT_TRUE(equal_in_any_case("c10", "C10"));
  EXPECT_FALSE(equal_in_any_case("c1", "C10"));
}

TEST(NearNames, AreMistypedOrShortened) {
  const std::vector<std::string> known = {"simulate", "threshold", "profile-count-2-C1"};
  EXPECT_THAT(near_names("simulte", known), ElementsAre("simulate"));
  EXPECT_THAT(near_names("thresh", known), ElementsAre("threshold"));
  EXPECT_THAT(near_names("profile-2-C1", known), ElementsAre("profile-count-2-C1"));
  EXPECT_THAT(near_names("hammer", known), IsEmpty());
  EXPECT_THAT(near_names(std::string(1'000'000, 's'), known), IsEmpty());
}

TEST(NearNames, AreTheNearestThree) {
  EXPECT_THAT(near_names("C", {"C1", "C", "C2", "C3"}), ElementsAre("C", "C1", "C2"));
}

TEST(WhatInstead, NamesWhatIsAllowedWhereNothingIsNear) {
  EXPECT_EQ(what_instead("masss", {"mass", "pull"}), "did you mean mass?");
  EXPECT_EQ(what_instead("weight", {"mass", "pull"}), "allowed: mass, pull");
}

TEST(WhatInstead, NamesNoMoreThanSixty) {
  std::vector<std::string> known;
  for (int number = 0; number < 300; ++number) known.push_back(std::to_string(1000 + number));
  const std::string answer = what_instead("weight", known);
  EXPECT_TRUE(answer.starts_with("allowed: 1000, 1001, ")) << answer;
  EXPECT_TRUE(answer.ends_with(", 1059, and 240 more")) << answer;
  known.resize(60);
  EXPECT_TRUE(what_instead("weight", known).ends_with(", 1059"));
}

TEST(WhatInstead, PointsToTheListOfManyNames) {
  EXPECT_EQ(what_instead("masss", {"mass", "pull"}, "`ricochet list`"), "did you mean mass?");
  EXPECT_EQ(what_instead("weight", {"mass", "pull"}, "`ricochet list`"), "see `ricochet list`");
}

TEST(Match, IsExactOrTheOnlyOneInAnyCase) {
  const std::vector<std::string> known = {"count-C1", "Mass", "mass"};
  EXPECT_EQ(match("COUNT-c1", known), &known[0]);
  EXPECT_EQ(match("mass", known), &known[2]);
  EXPECT_EQ(match("MASS", known), nullptr);
  EXPECT_EQ(match("count", known), nullptr);
}

}  // namespace
}  // namespace ricochet
