#include "src/experiment/stored_campaign.h"

#include "src/experiment/archive.h"
#include "src/experiment/archived_campaign.h"
#include "src/experiment/planned_runs.h"
#include "tests/experiment/store/stored.h"

namespace ricochet {
namespace {

Provenance of_version(const std::string& version) {
  return {{{"version", version}}, {}};
}

const std::string grid =
    part_of("\"bowl-*\"", "machines = {around = \"C1\", restitution = [0.25, 0.5]}");

class StoredCampaigns : public TemporaryFolder {
 protected:
  StoredCampaign opened(const std::string& plan, const std::string& version = "1") const {
    return stored_campaign(plan_from(plan, "test"), catalogue_, file_, of_version(version));
  }

  void expect_refused(const std::string& plan, const std::string& version,
                      const std::string& words) const {
    EXPECT_THAT(complaint_of([&] { return opened(plan, version); }), HasSubstr(words));
  }

  /// Makes all runs that the store lacks, and returns how many it had.
  std::int64_t complete(const std::string& plan) const {
    StoredCampaign stored = opened(plan);
    const std::int64_t kept = stored.store.size();
    make_runs(stored.campaign, {}, stored.store);
    EXPECT_EQ(stored.store.size(), stored.campaign.runs());
    return kept;
  }

  const fs::path file_ = folder_ / "runs.sqlite";
  std::shared_ptr<int> searches_ = std::make_shared<int>(0);
  Catalogue catalogue_ = searched_catalogue(searches_);
};

TEST_F(StoredCampaigns, SearchOnceAndReadTheFindingsFromTheStoreAfterwards) {
  const Campaign planned = made_up_campaign(grid, catalogue_);
  EXPECT_EQ(planned.to_search().size(), 2U);
  EXPECT_EQ(planned.runs(), 2 * 15);
  EXPECT_EQ(*searches_, 0) << "a plan is checked without a search";
  {
    StoredCampaign stored = opened(grid);
    EXPECT_EQ(*searches_, 2);
    EXPECT_TRUE(stored.campaign.to_search().empty());
    EXPECT_EQ(stored.store.description().problems[0].findings, (Findings{{"best_point", 0.3}}));
    make_runs(stored.campaign, {}, stored.store);
    EXPECT_FALSE(fs::exists(folder_ / "runs.sqlite-wal")) << "it can be copied now";
    EXPECT_EQ(caution(file_), "");
  }
  const StoredCampaign again = opened(grid);
  EXPECT_EQ(*searches_, 2);
  EXPECT_EQ(again.store.size(), again.campaign.runs());
  EXPECT_EQ(again.campaign.description().problems, again.store.description().problems);
}

TEST_F(StoredCampaigns, LeaveOutWhatIsFeasibleNowhere) {
  const std::string plan =
      part_of("\"bowl-*\"", "machines = {around = \"nowhere\", restitution = [0.25, 0.5, 1]}");
  EXPECT_EQ(made_up_campaign(plan, catalogue_).to_search().size(), 3U);
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
  expect_refused(part_of("\"bowl-2\""), "1", "runs.sqlite: is of another plan");
  expect_refused(plan, "2", "runs.sqlite: is made by another program");
  EXPECT_EQ(complete(plan), 0);
  EXPECT_EQ(opened(plan, "2").store.size(), 15) << "no run is missing: anybody may read it";
  catalogue_.families[0].problems[0].upper[0] = 2;
  expect_refused(plan, "1", "runs.sqlite: is of other problems");
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
  for (const auto& [version, content, kept] : {std::tuple("1", "", 0),
                                               {"1", "a", 15},  // an earlier ricochet recorded none
                                               {"1", "a", 30},
                                               {"1", "b", 15},
                                               {"2", "b", 15}}) {
    catalogue_ = with_mine(base, version, content);
    EXPECT_EQ(complete(plan), kept) << version << content;
  }
  catalogue_ = with_mine(base, "2", "c");
  expect_refused(plan, "2", "a solver that has changed, and made by another");
  EXPECT_EQ(reading(file_).size(), 30);
}

TEST_F(StoredCampaigns, SearchWhatOnlyAChangedSolverTakes) {
  const std::string plan =
      grid +
      part_of("\"cup-2\"", "solvers = [\"./mine\"]\nformulations = [\"original\", \"penalised\"]");
  const Catalogue base = catalogue_;
  catalogue_ = with_mine(base, "1", "a");
  EXPECT_EQ(opened(plan).campaign.runs(), 2 * 15 + 15);
  catalogue_ = with_mine(base, "1", "b", Capabilities::Constraints::all);
  EXPECT_EQ(opened(plan).campaign.runs(), 2 * 15 + 2 * 15);
  EXPECT_EQ(*searches_, 2) << "what was found is kept";
}

TEST_F(StoredCampaigns, KeepWhatAUsersSolverTakes) {
  using Constraints = Capabilities::Constraints;
  for (const auto taken : {Constraints::none, Constraints::inequalities, Constraints::all}) {
    for (const auto order : {Capabilities::Order::value, Capabilities::Order::gradient}) {
      const bool residuals = order != Capabilities::Order::value;
      const Capabilities all{
          .constraints = taken, .derivatives = order, .needs_residuals = residuals};
      EXPECT_EQ(capabilities_from(text_of(all)), all) << text_of(all);
    }
  }
}

/// An archive of the runs of two solvers on two problems, made by the catalogue.
class ArchivedCampaign : public TemporaryFolder {
 protected:
  const Catalogue catalogue_ = made_up_catalogue();
  const fs::path archive_ = folder_ / "archive", made_ = folder_ / "made.sqlite",
                 runs_ = folder_ / "runs.sqlite";

  static Plan plan_of_instances(int count) {
    return plan_from(
        "name = \"all\"\n" + part_of("\"bowl-[12]\"", "solvers = \"chance-*\"\ninstances = " +
                                                          std::to_string(count)),
        "test");
  }

  void SetUp() override {
    TemporaryFolder::SetUp();
    StoredCampaign made = stored_campaign(plan_of_instances(3), catalogue_, made_, of_version("1"));
    make_runs(made.campaign, {}, made.store);
    write_archive(made.store, archive_, [](const RunKey&) { return true; });
  }

  CampaignDescription described() const { return reading(archive_).description(); }

  Plan against(const Catalogue& catalogue) const {
    return plan_against(described(), {"./mine"}, catalogue);
  }

  /// The same catalogue, where bowl-2 is another problem.
  Catalogue with_another_problem() const {
    Catalogue changed = catalogue_;
    changed.families[0].problems[1].tolerance = 0.125;
    return changed;
  }
};

TEST_F(ArchivedCampaign, LeavesOnlyTheUsersRunsToBeMade) {
  const Plan plan = against(catalogue_);
  EXPECT_EQ(plan.name, "compare against all");
  EXPECT_THAT(plan.parts[0].solvers, ElementsAre("chance-a", "chance-b", "./mine"));
  start_against(reading(archive_), archive_, Campaign(plan, catalogue_), of_version("2"), runs_);
  StoredCampaign joint = stored_campaign(plan, catalogue_, runs_, of_version("2"));
  EXPECT_EQ(joint.store.size(), 2 * 2 * 3);
  EXPECT_EQ(joint.campaign.runs(), 3 * 2 * 3);
  make_runs(joint.campaign, {}, joint.store);
  EXPECT_EQ(joint.store.size(), joint.campaign.runs());
}

TEST_F(ArchivedCampaign, ComparesOnSomeOfItsProblems) {
  const auto plan_on = [&](const std::string& problems) {
    return plan_against(described(), {"./mine"}, catalogue_, {problems});
  };
  const Plan plan = plan_on("*-2");
  ASSERT_EQ(plan.parts.size(), 1U);
  EXPECT_THAT(plan.parts[0].problems, ElementsAre("bowl-2"));
  const Campaign campaign(plan, catalogue_);
  EXPECT_EQ(campaign.runs(), 3 * 3);
  start_against(reading(archive_), archive_, campaign, of_version("2"), runs_);
  EXPECT_EQ(reading(runs_).size(), 2 * 3);
  EXPECT_THAT(complaint_of([&] { return plan_on("bowl-8"); }), HasSubstr("bowl-8"));
}

TEST_F(ArchivedCampaign, LeavesOutSolversThatAreNotThere) {
  Catalogue here = catalogue_;
  std::erase_if(here.solvers, [](const Solver& solver) { return solver.name == "chance-a"; });
  here.solvers[0].version = "1.1";
  EXPECT_THAT(against(here).parts[0].solvers, ElementsAre("chance-b", "./mine"));
  const ChangedSolvers changes = changed_solvers(described(), here);
  EXPECT_THAT(changes.missing, ElementsAre("chance-a"));
  EXPECT_THAT(changes.changed, ElementsAre("chance-b (1, here 1.1)"));
}

TEST_F(ArchivedCampaign, IsRefusedIfAProblemIsAnotherOne) {
  const Catalogue changed = with_another_problem();
  const Campaign campaign(against(changed), changed);
  const auto start = [&] {
    return start_against(reading(archive_), archive_, campaign, {}, runs_), 0;
  };
  EXPECT_THAT(complaint_of(start), HasSubstr("the hashes of 1 of 2 differ: bowl-2"));
  EXPECT_FALSE(fs::exists(runs_));
}

TEST_F(ArchivedCampaign, LeavesRunsOfChangedProblemsAndSolversToBeMade) {
  Catalogue changed = with_another_problem();
  std::ranges::find(changed.solvers, "chance-a", &Solver::name)->version = "3";
  const Plan plan = plan_of_instances(4);
  start_from({made_, archive_}, Campaign(plan, changed), of_version("2"), runs_);
  StoredCampaign joint = stored_campaign(plan, changed, runs_, of_version("2"));
  std::set<std::string> taken;
  for (const RunKey& key : joint.store.keys()) taken.insert(address_of(key));
  const std::string cell = "bowl-1/original/plain/chance-b/10/n/";
  EXPECT_THAT(taken, ElementsAre(cell + "1/0", cell + "2/0", cell + "3/0"));
  make_runs(joint.campaign, {}, joint.store);
  EXPECT_EQ(joint.store.size(), 2 * 2 * 4);
}

TEST_F(ArchivedCampaign, OfAnArchiveStaysOne) {
  const Campaign campaign(plan_of_instances(2), catalogue_);
  for (const auto& [earlier, archived] : {std::pair(made_, false), {archive_, true}}) {
    start_from({earlier}, campaign, {}, runs_);
    EXPECT_EQ(reading(runs_).size(), 2 * 2 * 2);
    EXPECT_EQ(is_archived(reading(runs_).description()), archived);
    fs::remove(runs_);
  }
}

TEST_F(ArchivedCampaign, TakesInTheRunsOfAnotherSolver) {
  const CampaignDescription ours = described();
  const CampaignDescription theirs = description_of(Campaign(against(catalogue_), catalogue_), {});
  const CampaignDescription all = united(ours, theirs);
  ASSERT_EQ(all.solvers.size(), 3U);
  EXPECT_EQ(all.solvers[2].name, "mine");
  EXPECT_THAT(plan_from(all.plan, "test").parts[0].solvers, ElementsAre("chance-*", "./mine"));
  const auto complaint = [](const CampaignDescription& first, const CampaignDescription& second) {
    return complaint_of([&] { return united(first, second); });
  };
  CampaignDescription other = theirs;
  other.solvers[0].version = "3";
  EXPECT_THAT(complaint(ours, other), HasSubstr("chance-a in version 1, this in version 3"));
  other = theirs;
  other.problems[0].hash = "another";
  EXPECT_THAT(complaint(ours, other), HasSubstr("bowl-1"));
  CampaignDescription first = ours;
  first.solvers.push_back({"mine", "1", "a"});
  EXPECT_EQ(united(first, first), first);
  CampaignDescription second = first;
  second.solvers.back().content = "b";
  EXPECT_THAT(complaint(first, second), HasSubstr("has runs of another mine"));
}

}  // namespace
}  // namespace ricochet
