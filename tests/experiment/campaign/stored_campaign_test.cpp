#include "src/experiment/stored_campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "ricochet/error.h"
#include "src/experiment/planned_runs.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_campaign.h"

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

/// The made-up catalogue, whose user's solver ./mine has this version and content.
Catalogue with_mine(Catalogue catalogue, const std::string& version, const std::string& content,
                    Capabilities::Constraints constraints = Capabilities::Constraints::none) {
  catalogue.own_solver = [=](const std::string& text) -> std::optional<Solver> {
    if (text != "./mine") return std::nullopt;
    Solver mine = chance("mine");
    mine.version = version;
    mine.content = content;
    mine.capabilities.constraints = constraints;
    return mine;
  };
  return catalogue;
}

TEST_F(StoredCampaigns, LeaveRunsOfAChangedUsersSolverToBeMade) {
  const std::string plan = part_of("\"bowl-1\"", "solvers = [\"chance-a\", \"./mine\"]");
  const Catalogue base = catalogue_;
  const auto runs_with = [&](const std::string& version, const std::string& content) {
    catalogue_ = with_mine(base, version, content);
    StoredCampaign stored = opened(plan);
    const std::int64_t kept = stored.store.size();
    make_runs(stored.campaign, {}, stored.store);
    EXPECT_EQ(stored.store.size(), 30);
    return kept;
  };
  EXPECT_EQ(runs_with("1", ""), 0);
  EXPECT_EQ(runs_with("1", "a"), 15) << "an earlier ricochet did not record the content";
  EXPECT_EQ(runs_with("1", "a"), 30);
  EXPECT_EQ(runs_with("1", "b"), 15);
  EXPECT_EQ(runs_with("2", "b"), 15);
  catalogue_ = with_mine(base, "2", "c");
  EXPECT_THAT(
      [&] { opened(plan, "2"); },
      ThrowsMessage<InputError>(HasSubstr("a solver that has changed, and made by another")));
  EXPECT_EQ(Store::open(folder_ / "runs.sqlite", Store::For::reading).size(), 30);
}

TEST_F(StoredCampaigns, SearchWhatOnlyAChangedSolverTakes) {
  const std::string plan = grid + part_of("\"cup-2\"",
                                          "solvers = [\"./mine\"]\n"
                                          "formulations = [\"original\", \"penalised\"]");
  const Catalogue base = catalogue_;
  catalogue_ = with_mine(base, "1", "a");
  EXPECT_EQ(opened(plan).campaign.runs(), 2 * 15 + 15);
  catalogue_ = with_mine(base, "1", "b", Capabilities::Constraints::all);
  EXPECT_EQ(opened(plan).campaign.runs(), 2 * 15 + 2 * 15);
  EXPECT_EQ(*searches_, 2) << "what was found is kept";
}

TEST_F(StoredCampaigns, KeepWhatAUsersSolverTakes) {
  using Constraints = Capabilities::Constraints;
  for (const Constraints constraints :
       {Constraints::none, Constraints::inequalities, Constraints::all}) {
    for (const bool more : {false, true}) {
      Capabilities capabilities;
      capabilities.constraints = constraints;
      capabilities.needs_residuals = more;
      if (more) capabilities.derivatives = Capabilities::Order::gradient;
      EXPECT_EQ(capabilities_from(text_of(capabilities)), capabilities) << text_of(capabilities);
    }
  }
}

}  // namespace
}  // namespace ricochet
