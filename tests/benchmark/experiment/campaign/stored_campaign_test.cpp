#include "src/benchmark/experiment/campaign/stored_campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/planned_runs.h"
#include "tests/benchmark/experiment/campaign/made_up_campaign.h"
#include "tests/core/temporary_folder.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string grid =
    part_of("\"bowl-*\"", "machines = {around = \"C1\", restitution = [0.25, 0.5]}");

class StoredCampaigns : public TemporaryFolder {
 protected:
  StoredCampaign opened(const std::string& plan, const std::string& version = "1") const {
    return stored_campaign(plan_from(plan, "test"), catalogue_, folder_ / "runs.sqlite",
                           {{{"version", version}}, {}});
  }

  std::shared_ptr<int> searches_ = std::make_shared<int>(0);
  Catalogue catalogue_ = searched_catalogue(searches_);
};

TEST_F(StoredCampaigns, SearchOnceAndReadTheFindingsFromTheStoreAfterwards) {
  const Campaign planned(plan_from(grid, "test"), catalogue_);
  EXPECT_EQ(planned.to_search().size(), 2U);
  EXPECT_EQ(planned.runs(), 2 * 15);
  EXPECT_EQ(*searches_, 0) << "a plan is checked without a search";
  {
    StoredCampaign stored = opened(grid);
    EXPECT_EQ(*searches_, 2);
    EXPECT_TRUE(stored.campaign.to_search().empty());
    EXPECT_EQ(stored.store.description().problems[0].findings, (Findings{{"best_point", 0.3}}));
    make_runs(stored.campaign, {}, stored.store);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "runs.sqlite-wal")) << "it can be copied now";
    EXPECT_EQ(caution(folder_ / "runs.sqlite"), "");
  }
  const StoredCampaign again = opened(grid);
  EXPECT_EQ(*searches_, 2);
  EXPECT_EQ(again.store.size(), again.campaign.runs());
  EXPECT_EQ(again.campaign.description().problems, again.store.description().problems);
}

TEST_F(StoredCampaigns, LeaveOutWhatIsFeasibleNowhere) {
  const std::string plan =
      part_of("\"bowl-*\"", "machines = {around = \"nowhere\", restitution = [0.25, 0.5, 1]}");
  EXPECT_EQ(Campaign(plan_from(plan, "test"), catalogue_).to_search().size(), 3U);
  EXPECT_EQ(opened(plan).campaign.problems().size(), 2U) << "not of restitution 1";
  EXPECT_EQ(opened(plan).campaign.problems().size(), 2U) << "the store knows that, too";
  EXPECT_EQ(*searches_, 3);
}

TEST_F(StoredCampaigns, AskOfMachinesThatAreDrawn) {
  const StoredCampaign stored = opened(part_of("\"bowl-[12]\"", "drawn_machines = 2"));
  ASSERT_EQ(stored.campaign.cells().size(), 2U) << "of one variable only";
  EXPECT_EQ(stored.campaign.cells()[1].cell.problem, "bowl-1~2");
  EXPECT_EQ(stored.campaign.family_of(1), "bowl");
  EXPECT_EQ(*searches_, 2);
}

TEST_F(StoredCampaigns, RefuseAStoreOfAnotherPlanProgramOrData) {
  const std::string plan = part_of("\"bowl-1\"");
  { opened(plan); }
  const auto expect_refused = [&](const std::string& asked, const std::string& version,
                                  const std::string& reason) {
    EXPECT_THAT([&] { opened(asked, version); },
                ThrowsMessage<InputError>(HasSubstr("runs.sqlite: is " + reason)));
  };
  expect_refused(part_of("\"bowl-2\""), "1", "of another plan");
  expect_refused(plan, "2", "made by another program");
  catalogue_.families[0].problems[0].upper[0] = 2;
  expect_refused(plan, "1", "of other problems");
}

TEST_F(StoredCampaigns, AreReadByAnyProgramWhereNoRunIsMissing) {
  const std::string plan = part_of("\"bowl-1\"");
  {
    StoredCampaign stored = opened(plan);
    make_runs(stored.campaign, {}, stored.store);
  }
  EXPECT_EQ(opened(plan, "2").store.size(), 15);
}

}  // namespace
}  // namespace ricochet
