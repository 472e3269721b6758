#include "src/experiment/archived_campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "ricochet/error.h"
#include "src/experiment/archive.h"
#include "src/experiment/planned_runs.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_campaign.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// An archive of the runs of two solvers on two problems, made by the catalogue.
class ArchivedCampaign : public TemporaryFolder {
 protected:
  const Catalogue catalogue_ = made_up_catalogue();
  const fs::path archive_ = folder_ / "archive";

  void SetUp() override {
    TemporaryFolder::SetUp();
    const Plan plan = plan_from(
        "name = \"all\"\n" + part_of("\"bowl-[12]\"", "solvers = \"chance-*\"\ninstances = 3"),
        "test");
    StoredCampaign made =
        stored_campaign(plan, catalogue_, folder_ / "made.sqlite", {{{"version", "1"}}, {}});
    make_runs(made.campaign, {}, made.store);
    write_archive(made.store, archive_, [](const RunKey&) { return true; });
  }

  Plan against(const Catalogue& catalogue) const {
    const Store archive = Store::open(archive_, Store::For::reading);
    return plan_against(archive.description(), {"./mine"}, catalogue);
  }
};

TEST_F(ArchivedCampaign, LeavesOnlyTheUsersRunsToBeMade) {
  const Plan plan = against(catalogue_);
  EXPECT_EQ(plan.name, "compare against all");
  EXPECT_THAT(plan.parts[0].solvers, ElementsAre("chance-a", "chance-b", "./mine"));
  const fs::path file = folder_ / "runs.sqlite";
  const Provenance provenance = {{{"version", "2"}}, {}};
  start_against(Store::open(archive_, Store::For::reading), archive_, Campaign(plan, catalogue_),
                provenance, file);
  StoredCampaign joint = stored_campaign(plan, catalogue_, file, provenance);
  EXPECT_EQ(joint.store.size(), 2 * 2 * 3);
  EXPECT_EQ(joint.campaign.runs(), 3 * 2 * 3);
  const PlannedRuns left(joint.campaign, {}, joint.store.keys());
  std::set<std::string> solvers;
  for (const PlannedRun& run : left.all()) solvers.insert(run.key.cell.solver);
  EXPECT_THAT(solvers, ElementsAre("mine"));
  make_runs(joint.campaign, {}, joint.store);
  EXPECT_EQ(joint.store.size(), joint.campaign.runs());
}

TEST_F(ArchivedCampaign, ComparesOnSomeOfItsProblems) {
  const CampaignDescription description = Store::open(archive_, Store::For::reading).description();
  const Plan plan = plan_against(description, {"./mine"}, catalogue_, {"*-2"});
  ASSERT_EQ(plan.parts.size(), 1U);
  EXPECT_THAT(plan.parts[0].problems, ElementsAre("bowl-2"));
  const Campaign campaign(plan, catalogue_);
  EXPECT_EQ(campaign.runs(), 3 * 3);
  start_against(Store::open(archive_, Store::For::reading), archive_, campaign,
                {{{"version", "2"}}, {}}, folder_ / "some.sqlite");
  EXPECT_EQ(Store::open(folder_ / "some.sqlite", Store::For::reading).size(), 2 * 3);
  EXPECT_THAT([&] { plan_against(description, {"./mine"}, catalogue_, {"bowl-8"}); },
              ThrowsMessage<InputError>(HasSubstr("bowl-8")));
}

TEST_F(ArchivedCampaign, LeavesOutSolversThatAreNotThere) {
  Catalogue here = catalogue_;
  std::erase_if(here.solvers, [](const Solver& solver) { return solver.name == "chance-a"; });
  here.solvers[0].version = "1.1";
  EXPECT_THAT(against(here).parts[0].solvers, ElementsAre("chance-b", "./mine"));
  const ChangedSolvers changes =
      changed_solvers(Store::open(archive_, Store::For::reading).description(), here);
  EXPECT_THAT(changes.missing, ElementsAre("chance-a"));
  EXPECT_THAT(changes.changed, ElementsAre("chance-b (1, here 1.1)"));
}

TEST_F(ArchivedCampaign, IsRefusedIfAProblemIsAnotherOne) {
  Catalogue changed = catalogue_;
  changed.families[0].problems[1].tolerance = 0.125;
  const Plan plan = against(changed);
  EXPECT_THAT(
      [&] {
        start_against(Store::open(archive_, Store::For::reading), archive_, Campaign(plan, changed),
                      {}, folder_ / "runs.sqlite");
      },
      ThrowsMessage<InputError>(HasSubstr("the hashes of 1 of 2 differ: bowl-2")));
  EXPECT_FALSE(fs::exists(folder_ / "runs.sqlite"));
}

TEST_F(ArchivedCampaign, LeavesRunsOfChangedProblemsAndSolversToBeMade) {
  Catalogue changed = catalogue_;
  changed.families[0].problems[1].tolerance = 0.125;
  std::ranges::find(changed.solvers, "chance-a", &Solver::name)->version = "3";
  const Plan plan = plan_from(
      "name = \"more\"\n" + part_of("\"bowl-[12]\"", "solvers = \"chance-*\"\ninstances = 4"),
      "test");
  const Campaign campaign(plan, changed);
  const Provenance provenance = {{{"version", "2"}}, {}};
  const fs::path file = folder_ / "runs.sqlite";
  start_from({folder_ / "made.sqlite", archive_}, campaign, provenance, file);
  StoredCampaign joint = stored_campaign(plan, changed, file, provenance);
  for (const RunKey& key : joint.store.keys()) {
    EXPECT_EQ(key.cell.problem, "bowl-1");
    EXPECT_EQ(key.cell.solver, "chance-b");
    EXPECT_LE(key.instance, 3);
  }
  EXPECT_EQ(joint.store.size(), 3);
  make_runs(joint.campaign, {}, joint.store);
  EXPECT_EQ(joint.store.size(), 2 * 2 * 4);
}

TEST_F(ArchivedCampaign, OfAnArchiveStaysOne) {
  const Plan plan =
      plan_from(part_of("\"bowl-[12]\"", "solvers = \"chance-*\"\ninstances = 2"), "test");
  const fs::path file = folder_ / "runs.sqlite";
  start_from({folder_ / "made.sqlite"}, Campaign(plan, catalogue_), {}, file);
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 2 * 2 * 2);
  EXPECT_FALSE(is_archived(Store::open(file, Store::For::reading).description()));
  fs::remove(file);
  start_from({archive_}, Campaign(plan, catalogue_), {}, file);
  EXPECT_TRUE(is_archived(Store::open(file, Store::For::reading).description()));
}

TEST_F(ArchivedCampaign, TakesInTheRunsOfAnotherSolver) {
  const Plan plan = against(catalogue_);
  const Campaign campaign(plan, catalogue_);
  const CampaignDescription ours = Store::open(archive_, Store::For::reading).description();
  const CampaignDescription all = united(ours, description_of(campaign, {}));
  ASSERT_EQ(all.solvers.size(), 3U);
  EXPECT_EQ(all.solvers[2].name, "mine");
  EXPECT_THAT(plan_from(all.plan, "test").parts[0].solvers, ElementsAre("chance-*", "./mine"));
  CampaignDescription other = description_of(campaign, {});
  other.solvers[0].version = "3";
  EXPECT_THAT([&] { united(ours, other); },
              ThrowsMessage<InputError>(HasSubstr("chance-a in version 1, this in version 3")));
  other = description_of(campaign, {});
  other.problems[0].hash = "another";
  EXPECT_THAT([&] { united(ours, other); }, ThrowsMessage<InputError>(HasSubstr("bowl-1")));
}

TEST_F(ArchivedCampaign, IsNotJoinedWithOtherFilesOfAUsersSolver) {
  CampaignDescription first = Store::open(archive_, Store::For::reading).description();
  first.solvers.push_back({"mine", "1", "a"});
  CampaignDescription second = first;
  EXPECT_EQ(united(first, second), first);
  second.solvers.back().content = "b";
  EXPECT_THAT([&] { united(first, second); },
              ThrowsMessage<InputError>(HasSubstr("has runs of another mine")));
}

}  // namespace
}  // namespace ricochet
