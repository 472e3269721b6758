#include <gmock/gmock.h>

#include "src/report/site/entries.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::ElementsAre;

class FoundReports : public TemporaryFolder {};

TEST_F(FoundReports, AreThoseOfKnownKindsInTheirOrder) {
  keep(folder_, "zebra", {{"report", "reproduction"}});
  keep(folder_, "surrogate", {{"report", "surrogate"}});
  keep(folder_, "ant", {{"report", "reproduction"}});
  keep(folder_, "reference", {{"report", "site"}});
  keep(folder_, "other", {{"report", 7}});
  keep(folder_, "list", Json::array({1}));
  std::filesystem::create_directories(folder_ / "empty");
  keep(folder_, "broken", {});
  std::ofstream(folder_ / "broken" / "data.json") << "{";
  std::vector<std::string> labels;
  for (const FoundReport& report : found_reports(folder_)) labels.push_back(label_of(report));
  EXPECT_THAT(labels,
              ElementsAre("The paper's cases: ant", "The paper's cases: zebra", "Surrogate"));
  EXPECT_THAT(folders_of_data(folder_),
              ElementsAre("ant", "broken", "list", "other", "surrogate", "zebra"))
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
  report::Results results = *found_comparison().results;
  Json data = json_of(results);
  data["report"] = "comparison";
  data["pages"] = {"robustness", "gone"};
  data["made"] = {{"date", "2031-02-03"}, {"seconds", 1.5}, {"quick", false}};
  keep(folder_, "comparison", data);
  report::Results failures;
  failures.set("finding", "Noise harms.");
  Json page = json_of(failures);
  page["report"] = "comparison_failures";
  keep(folder_, "comparison/robustness", page);
  const auto reports = found_reports(folder_);
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].made.date, "2031-02-03");
  EXPECT_EQ(*reports[0].results->value("made.seconds"), Value(1.5));
  ASSERT_EQ(reports[0].pages.size(), 2U);
  EXPECT_EQ(reports[0].pages[0].folder, "robustness");
  EXPECT_EQ(reports[0].pages[0].headline->finding, "Noise harms.");
  EXPECT_EQ(reports[0].pages[0].headline->group, "Robustness");
  EXPECT_FALSE(reports[0].pages[1].headline);
}

TEST_F(FoundReports, OfAnotherVersionHaveNoHeadline) {
  keep(folder_, "verification", {{"report", "verification"}, {"values", "Found: all"}});
  keep(folder_, "surrogate", {{"report", "surrogate"}});  // and nothing else
  EXPECT_EQ(found_reports(folder_).size(), 2U);
  for (const FoundReport& report : found_reports(folder_)) EXPECT_FALSE(report.headline);
}

}  // namespace
}  // namespace ricochet::site
