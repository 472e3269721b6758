#include <gtest/gtest.h>

#include "src/report/site/navigation.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

class OwnPages : public TemporaryFolder {};

TEST_F(OwnPages, AreWrittenWhereNoReportHasTheirFolder) {
  keep(folder_, "machine", Json::object());
  std::vector<std::string> failures;
  const std::vector<Place> places =
      write_own_pages(folder_,
                      {{{"Machine", "Speeds", "machine"}, {"One", {}, {}}},
                       {{"Data", "Cite", "cite"}, {"Two", {}, {}}}},
                      failures);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].folder, "cite");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "cite/index.html"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "machine/index.html"));
  EXPECT_TRUE(failures.empty());
}

}  // namespace
}  // namespace ricochet::site
