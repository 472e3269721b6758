#include "src/analysis/comparison/study.h"

#include <gmock/gmock.h>

#include <set>

#include "src/experiment/planned_runs.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies {
namespace {

using report::Json;
using testing::HasSubstr;

class ComparisonStudy : public TemporaryFolder {
 protected:
  Json data_of(const std::string& plan) const {
    Catalogue catalogue = made_up_catalogue();
    catalogue.own_solver = nullptr;
    const Campaign campaign = searched_campaign(plan_from(plan, "test"), catalogue);
    Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
    make_runs(campaign, {}, store);
    return comparison_study(campaign, store).compute(false);
  }

  /// The filled page of a kind of report.
  static std::string filled(const Json& data) {
    Json made = data;
    made["made"] = {{"version", "1"},
                    {"compiler", "GCC"},
                    {"threads", 2},
                    {"seconds", 1},
                    {"date", "2026-01-01"}};
    const auto page = report::page_source(report::page_template(data.at("report")));
    return filled_page(page, report::results_of(made));
  }
};

TEST_F(ComparisonStudy, FillsEveryPageWithWhatItsNamesAskFor) {
  Json data = data_of(
      "[[part]]\nproblems = [\"bowl-1\", \"bowl-2\", \"cup-s\"]\nsolvers = \"*\"\n"
      "budgets = [10, 100]\ninstances = 2\nperturbations = [\"plain\", \"noisy\"]\n");
  data["report"] = "comparison";
  std::set<std::string> folders;
  EXPECT_THAT(filled(data), HasSubstr("| bowl | 100 |"));
  for (const Json& page : data.at("pages")) {
    folders.insert(page.at("folder").get<std::string>());
    EXPECT_THAT(filled(page.at("data")), testing::StartsWith("# ")) << page.at("folder");
  }
  EXPECT_EQ(folders, (std::set<std::string>{"bowl", "cup", "robustness", "solvers", "view"}));
}

TEST_F(ComparisonStudy, HasAMapOfWhoSolvesWhat) {
  const report::Results results =
      report::results_in(data_of("[[part]]\nproblems = [\"bowl-1\", \"cup-s\"]\nsolvers = \"*\"\n"
                                 "budgets = [100]\ninstances = 2\n"));
  const Table& map = *results.table("map");
  ASSERT_EQ(map.rows.size(), 3U);
  EXPECT_TRUE(map.has("bowl"));
  EXPECT_TRUE(map.has("cup"));
  each_row(map, [&](const Row& row) {
    const Table own = where(*results.table("speed-accuracy"), [&](const Row& other) {
      return other["solver"] == row["solver"] && other.text("family") == "bowl";
    });
    EXPECT_EQ(row["bowl"], own[0]["share"]);
  });
}

}  // namespace
}  // namespace ricochet::studies
