#include "src/site/card.h"

#include <gmock/gmock.h>

#include "tests/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

TEST(Verdict, IsTheFirstSentenceThatSomethingWasFound) {
  EXPECT_EQ(verdict_of({"How to read it. Slowly.", "Found: in 0.5 s of 3 runs. More is below."}),
            "In 0.5 s of 3 runs.");
  EXPECT_EQ(verdict_of({"Found: nothing"}), "Nothing");
}

TEST(Verdict, IsTheFirstSentenceOfAllWhereNothingWasFound) {
  EXPECT_EQ(verdict_of({"One. Two.", "Three."}), "One.");
  EXPECT_EQ(verdict_of({}), "");
}

TEST(Card, SaysWhatAReportOfThisVersionFound) {
  const FoundReport stress = made_up(
      "stress",
      {{"made",
        {{"version", "1"}, {"compiler", "GCC"}, {"threads", 2}, {"seconds", 4.5}, {"quick", true}}},
       {"counts",
        {{"runs", 7},
         {"solved", 3},
         {"spent", 4},
         {"ended", 0},
         {"threw", 0},
         {"killed", 0},
         {"crashed", 0}}},
       {"problems", Json::array()},
       {"solvers", Json::array()}},
      "stress");
  const Json card = card_of(stress);
  EXPECT_THAT(card["verdict"].get<std::string>(), HasSubstr("Of 7 runs 3 solved"));
  EXPECT_EQ(card["quick"], true);
  EXPECT_EQ(card["command"], "./ricochet stress");
  EXPECT_TRUE(card["date"].is_null());
}

TEST(Card, OfDataThatDoNotFitTheTemplateSaysSo) {
  const Json card = card_of(made_up("stress", Json::object(), "stress"));
  EXPECT_THAT(card["verdict"].get<std::string>(), HasSubstr("another version"));
}

TEST(MissingCards, NameEveryKindThatHasNoReport) {
  const Json cards = missing_cards({made_up("stress", Json::object(), "stress")});
  EXPECT_EQ(cards.size(), report_kinds().size() - 1);
  for (const Json& card : cards) EXPECT_NE(card["kind"], "stress");
}

TEST(Card, OfACampaignNamesItsPlan) {
  Json data = small_contest();
  data["campaign"] = "default";
  data["made"] = {{"seconds", 18}};
  const Json card = card_of(made_up("contest", data, "contest"));
  EXPECT_EQ(card["command"], "./ricochet run default");
  EXPECT_TRUE(card["seconds"].is_null());
  data["campaign"] = "compare --quick";
  EXPECT_EQ(card_of(made_up("contest", data, "contest"))["command"], "./ricochet compare");
}

}  // namespace
}  // namespace ricochet::site
