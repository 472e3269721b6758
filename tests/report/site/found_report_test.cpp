#include <gmock/gmock.h>

#include "src/report/site/entries.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::ElementsAre;

class FoundReports : public TemporaryFolder {};

TEST_F(FoundReports, AreThoseOfKnownKindsInTheirOrder) {
  keep(folder_, "zebra", {{"report", "reproduction"}});
  keep(folder_, "dynamics", {{"report", "dynamics"}});
  keep(folder_, "ant", {{"report", "reproduction"}});
  keep(folder_, "reference", {{"report", "site"}});
  keep(folder_, "other", {{"report", 7}});
  keep(folder_, "list", Json::array({1}));
  std::filesystem::create_directories(folder_ / "empty");
  keep(folder_, "broken", {});
  std::ofstream(folder_ / "broken" / "data.json") << "{";
  std::vector<std::string> labels;
  for (const FoundReport& report : found_reports(folder_)) labels.push_back(label_of(report));
  EXPECT_THAT(labels, ElementsAre("The paper's cases: ant", "The paper's cases: zebra",
                                  "Methods and contact laws"));
  EXPECT_THAT(folders_of_data(folder_),
              ElementsAre("ant", "broken", "dynamics", "list", "other", "zebra"))
      << "what is not of a known kind may have been a report";
}

TEST_F(FoundReports, AreNotReadDeeperThanTheStackHolds) {
  const std::size_t levels = 200'000;
  std::filesystem::create_directories(folder_ / "surrogate");
  std::ofstream(folder_ / "surrogate" / "data.json")
      << R"({"report":"surrogate","deep":)" << std::string(levels, '[') << std::string(levels, ']')
      << "}";
  EXPECT_TRUE(found_reports(folder_).empty());
  EXPECT_THAT(folders_of_data(folder_), ElementsAre("surrogate"));
}

TEST_F(FoundReports, OfAFolderThatIsNoneAreNone) {
  EXPECT_TRUE(found_reports("/nowhere").empty());
}

TEST_F(FoundReports, HaveTheirPagesAndWhatTheseSayOfThemselves) {
  report::Headline headline;
  headline.version = report::headline_version;
  headline.holds = {"family"};
  keep(folder_, "comparison", {{"report", "comparison"}, {"pages", {"count", "gone"}}});
  keep(folder_, "comparison/count",
       {{"report", "comparison_family"}, {"family", "count"}, {"headline", headline}});
  const auto reports = found_reports(folder_);
  ASSERT_EQ(reports.size(), 1U);
  ASSERT_EQ(reports[0].pages.size(), 2U);
  EXPECT_EQ(reports[0].pages[0].folder, "count");
  EXPECT_TRUE(holds(reports[0].pages[0].headline, "family"));
  EXPECT_FALSE(holds(reports[0].pages[0].headline, "entries"));
  EXPECT_FALSE(reports[0].pages[1].headline);
}

TEST_F(FoundReports, OfAnotherVersionHaveNoHeadline) {
  report::Headline headline;
  headline.version = report::headline_version + 1;
  keep(folder_, "stress", {{"report", "stress"}, {"headline", headline}});
  keep(folder_, "verification", {{"report", "verification"}, {"headline", "Found: all"}});
  headline.version = report::headline_version;
  keep(folder_, "surrogate",
       {{"report", "surrogate"}, {"headline", headline}});  // and nothing else
  EXPECT_EQ(found_reports(folder_).size(), 3U);
  for (const FoundReport& report : found_reports(folder_)) EXPECT_FALSE(report.headline);
}

}  // namespace
}  // namespace ricochet::site
