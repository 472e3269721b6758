#include "src/report/site/front.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "src/report/results.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

FoundReport telling() {
  FoundReport report = made_up("reproduction", Json::object(), "first");
  report.headline->finding = "All is well.";
  report.headline->excerpts = {
      {"speed", "8 rad/s", "in all", {{"cases", "#thresholds"}}, {}},
      {"question", "How fast?", "So.", {{"a page", "count#there"}, {"its own", ""}}, {}},
      {"nobody's", "lost", "", {}, {}}};
  report.headline->excerpts[0].table = {"Speeds",
                                        {{"cases", report::Alignment::left}, {"speed"}},
                                        {{{.text = "C1", .link = "#c1"}, {"8"}}}};
  return report;
}

TEST(Front, PutsExcerptsUnderTheirTopics) {
  const Front front = front_of({telling()});
  ASSERT_EQ(front.speed.size(), 1U);
  EXPECT_EQ(front.speed[0].heading, "8 rad/s");
  EXPECT_EQ(front.speed[0].links[0].folder, "first");
  EXPECT_EQ(front.speed[0].links[0].anchor, "#thresholds");
  EXPECT_TRUE(front.speed[0].columns[0].left);
  EXPECT_EQ(front.speed[0].rows[0].cells[0].folder, "first");
  EXPECT_EQ(front.speed[0].rows[0].cells[0].anchor, "#c1");
  EXPECT_EQ(front.speed[0].rows[0].cells[1].folder, "");
  const FrontExcerpt& question = front.question.back();  // after those of the site itself
  EXPECT_EQ(question.heading, "How fast?");
  EXPECT_EQ(question.links[0].folder, "first/count");
  EXPECT_EQ(question.links[0].anchor, "#there");
  EXPECT_EQ(question.links[1].folder, "first");
}

TEST(Front, HasTheSpeedsOfThePapersMachinesByRestitutionAndFriction) {
  report::Results results;
  ricochet::Table cases{"thresholds",
                        {{"case"},
                         {"restitution"},
                         {"friction"},
                         {"disturbance"},
                         {"silent_up_to"},
                         {"quiet_up_to"},
                         {"paper_threshold"}}};
  cases.add("C1", 0.1, 0.1, 0, 1.5, 8.0, 9);
  cases.add("C2", 0.9, 0.1, 0, 1.5, 2.0, std::nullopt);
  cases.add("C3", 0.1, 0.4, 0, 2.9, 12.1, 13);
  cases.add("C5", 0.1, 0.1, 0.1, 1.4, 7.5, 8);
  results.add(cases);
  const Front front = front_of({made_up("reproduction", json_of(results), "first")});
  ASSERT_EQ(front.speed.size(), 1U);
  EXPECT_EQ(front.speed[0].heading, "2.0 to 12.1 rad/s");
  EXPECT_THAT(front.speed[0].text, HasSubstr("19 to 116 rpm"));
  std::vector<std::string> texts;
  for (const FrontRow& row : front.speed[0].rows) {
    std::string text;
    for (const FrontCell& cell : row.cells) text += cell.text + "|";
    texts.push_back(text);
  }
  EXPECT_THAT(texts, testing::ElementsAre("C3|0.1|0.4|2.90|12.10|13|",
                                          "C1, C5|0.1|0.1|1.40–1.50|7.50–8.00|8–9|",
                                          "C2|0.9|0.1|1.50|2.00||"));
  const auto asked =
      std::ranges::find(front.question, "How fast may C3 run?", &FrontExcerpt::heading);
  ASSERT_NE(asked, front.question.end());
  EXPECT_EQ(asked->text, "12.10 rad/s, 116 rpm.");
}

TEST(Front, HasTheExcerptsOfFurtherPagesToo) {
  FoundReport report = telling();
  report.pages.push_back({"further", report.headline, Json::object()});
  const Front front = front_of({report});
  ASSERT_EQ(front.speed.size(), 2U);
  EXPECT_EQ(front.speed[1].links[0].folder, "first/further");
}

TEST(Front, HasTheChartsOfTheFirstReportThatHasSome) {
  std::vector<FoundReport> reports(2, telling());
  reports[1].folder = "second";
  reports[1].headline->holds = {"simulations"};
  reports[1].headline->charts.push_back({.name = "mild", .title = "Mild", .x = {}, .y = {}});
  const Front front = front_of(reports);
  ASSERT_TRUE(front.motion);
  EXPECT_EQ(front.motion->folder, "second");
  EXPECT_FALSE(front_of({telling()}).motion);
}

TEST(Front, PlacesSolversFromOutsideWithTheLargestBudget) {
  const Front front = front_of({found_comparison()});
  ASSERT_EQ(front.own.size(), 1U);
  ASSERT_EQ(front.own[0].rows.size(), 1U);
  std::vector<std::string> texts;
  for (const FrontCell& cell : front.own[0].rows[0].cells) texts.push_back(cell.text);
  EXPECT_THAT(texts, testing::ElementsAre("mine, count", "count", "100", "2 of 2"));
}

TEST(Cards, SayWhatAReportFoundAndWhatMadeIt) {
  FoundReport report = telling();
  report.made = {"2026-01-02", 4.5, true};
  const Card card = front_of({report}).cards.at(0);
  EXPECT_EQ(card.title, "What reproduction found");
  EXPECT_EQ(card.finding, "All is well.");
  EXPECT_EQ(card.command, "./ricochet reproduce");
  EXPECT_EQ(card.seconds, 4.5);
  EXPECT_TRUE(card.quick);
}

TEST(Cards, OfAReportThatWasDrawnFromRunsHaveNoTime) {
  FoundReport report = telling();
  report.made.seconds = 18;
  report.headline->command = "./ricochet run plan";
  const Card card = front_of({report}).cards.at(0);
  EXPECT_EQ(card.command, "./ricochet run plan");
  EXPECT_FALSE(card.seconds);
}

TEST(Cards, SayWhenDataAreOfAnotherVersion) {
  FoundReport report = telling();
  report.headline.reset();
  EXPECT_THAT(front_of({report}).cards.at(0).finding, HasSubstr("another version"));
  EXPECT_TRUE(front_of({report}).unread.empty());
  FoundReport comparison = found_comparison();
  comparison.data["speed_accuracy"] = 7;
  const Front front = front_of({comparison});
  EXPECT_FALSE(front.comparison);
  EXPECT_THAT(front.cards.at(0).finding, HasSubstr("another version"));
  EXPECT_THAT(front.unread,
              testing::ElementsAre(testing::Pair("comparison", HasSubstr("speed_accuracy"))));
}

TEST(Cards, OfAReportWithAPageThatCannotBeReadSayWhichItIs) {
  Json family = small_family();
  family["budgets"][0]["ratings"][0]["share"] = "all";
  const Front front = front_of({found_comparison(small_comparison(), {family})});
  EXPECT_FALSE(front.comparison);
  EXPECT_THAT(front.unread,
              testing::ElementsAre(testing::Pair("comparison/count", HasSubstr("share"))));
}

TEST(MissingReports, AreTheKindsOfWhichThereIsNone) {
  const Front front = front_of({telling()});
  EXPECT_EQ(front.missing.size(), report::report_kinds().size() - 1);
  for (const report::ReportKind& kind : front.missing) EXPECT_NE(kind.name, "reproduction");
}

}  // namespace
}  // namespace ricochet::site
