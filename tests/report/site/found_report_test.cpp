#include "src/site/found_report.h"

#include <gmock/gmock.h>

#include "tests/site/made_up_reports.h"

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
  EXPECT_THAT(labels,
              ElementsAre("The paper's cases: ant", "The paper's cases: zebra", "The motion"));
}

TEST_F(FoundReports, OfAFolderThatIsNoneAreNone) {
  EXPECT_TRUE(found_reports("/nowhere").empty());
}

TEST_F(FoundReports, HaveTheFamiliesOfAContest) {
  keep(folder_, "contest", {{"report", "contest"}, {"pages", {"count", "hs", "failure-atlas"}}});
  keep(folder_, "contest/count", {{"report", "contest_family"}, {"family", "count"}});
  keep(folder_, "contest/hs", {{"report", "contest_family"}, {"family", "hs"}});
  keep(folder_, "contest/failure-atlas", {{"report", "contest_failures"}});
  const auto reports = found_reports(folder_);
  ASSERT_EQ(reports.size(), 1U);
  const Json& groups = reports[0].data["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0]["family"], "count");
  EXPECT_EQ(groups[1]["family"], "hs");
}

}  // namespace
}  // namespace ricochet::site
