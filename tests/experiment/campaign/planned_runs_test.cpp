#include "src/experiment/planned_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "src/experiment/worker.h"
#include "tests/experiment/campaign/made_up_campaign.h"

namespace ricochet {
namespace {

std::vector<RunKey> keys_of(const PlannedRuns& runs) {
  std::vector<RunKey> keys;
  for (const PlannedRun& run : runs.all()) keys.push_back(run.key);
  return keys;
}

TEST(PlannedRuns, OfShardsAreDisjointAndCompleteWhateverIsDone) {
  const Campaign campaign = campaign_of(part_of(
      "\"*\"",
      "solvers = \"*\"\nperturbations = \"*\"\ninstances = 4\nseeds = 2\nbudgets = [3, 7]"));
  const auto whole = keys_of(PlannedRuns(campaign, {}, {}));
  EXPECT_EQ(static_cast<std::int64_t>(whole.size()), campaign.runs());
  const std::set<RunKey> every(whole.begin(), whole.end());
  ASSERT_EQ(every.size(), whole.size());
  std::mt19937_64 random(1);
  for (const int count : {1, 2, 3, 7, 1000}) {
    std::set<RunKey> seen;
    for (int index = 1; index <= count; ++index) {
      std::set<RunKey> done;  // by this shard, before
      for (const RunKey& key : whole) {
        if (random() % 3 == 0) done.insert(key);
      }
      const auto all = keys_of(PlannedRuns(campaign, {index, count}, {}));
      auto left = keys_of(PlannedRuns(campaign, {index, count}, done));
      for (const RunKey& key : all) {
        EXPECT_TRUE(seen.insert(key).second) << name_of(key);
        const bool is_left = std::find(left.begin(), left.end(), key) != left.end();
        EXPECT_NE(is_left, done.contains(key));
      }
      EXPECT_LE(left.size(), all.size());
    }
    EXPECT_EQ(seen, every) << count;
  }
}

TEST(PlannedRuns, BeginAtThePlansFirstInstance) {
  const std::string parts = part_of("\"bowl-1\"", "instances = 2");
  const Campaign later = campaign_of("first_instance = 4\n" + parts);
  std::set<int> instances;
  const PlannedRuns planned(later, {}, {});
  for (const PlannedRun& run : planned.all()) {
    instances.insert(run.key.instance);
    EXPECT_EQ(run.job.problem->instance, run.key.instance);
    EXPECT_TRUE(later.has(run.key));
    EXPECT_FALSE(campaign_of(parts).has(run.key));
  }
  EXPECT_EQ(instances, (std::set<int>{4, 5}));
  EXPECT_EQ(later.runs(), 2);
}

TEST(PlannedRuns, BeginWithTheLongest) {
  const Campaign campaign = campaign_of(part_of("\"bowl-*\"", "budgets = [5, 50]"));
  const PlannedRuns planned(campaign, {}, {});
  EXPECT_TRUE(std::is_sorted(planned.all().begin(), planned.all().end(),
                             [](const auto& a, const auto& b) { return a.length > b.length; }));
  EXPECT_EQ(planned.all().front().length, 8.0 * 8 * 50);
}

TEST(PlannedRuns, AreSeededByAllThatTheyAreCalled) {
  const Campaign campaign = campaign_of(
      part_of("\"cup-s\"",
              "solvers = \"*\"\nperturbations = [\"plain\", \"noisy\"]\ninstances = 2\nseeds = 2"));
  const PlannedRuns planned(campaign, {}, {});
  std::vector<Job> jobs;
  for (const PlannedRun& run : planned.all()) jobs.push_back(run.job);
  std::set<std::uint64_t> seeds;
  run_all(jobs, {}, [&](std::size_t j, const RunRecord& record) {
    EXPECT_TRUE(seeds.insert(record.seed).second) << name_of(planned.all()[j].key);
    EXPECT_EQ(record.instance, planned.all()[j].key.instance);
    EXPECT_EQ(record.run, planned.all()[j].key.run);
  });
  EXPECT_EQ(static_cast<std::int64_t>(seeds.size()), campaign.runs());
}

TEST(PlannedRuns, HaveTheirBestPointWhereTheOptimumIsRelocated) {
  const Campaign campaign = campaign_of(part_of("\"bowl-2\"", "relocated_optimum = true"));
  const PlannedRuns planned(campaign, {}, {});
  ASSERT_EQ(planned.all().size(), 3U * 15);
  for (const PlannedRun& run : planned.all()) {
    const Problem& problem = *run.job.problem;
    const Vector& best = *problem.best_point;
    EXPECT_EQ(problem.lower == best, run.key.cell.perturbation == "optimum-at-lower-end");
    EXPECT_EQ(problem.upper == best, run.key.cell.perturbation == "optimum-at-upper-end");
    EXPECT_EQ(problem.instance, run.key.instance);
    EXPECT_EQ(run.job.perturbation, nullptr);
  }
}

TEST(PlannedRuns, AreFoundOneByOneAsTheyAreAmongAll) {
  const Campaign campaign = campaign_of(
      part_of("\"*\"",
              "solvers = \"*\"\nperturbations = [\"plain\", \"noisy\"]\ninstances = 2\nseeds = 2"));
  const PlannedRuns planned(campaign, {}, {});
  for (const PlannedRun& run : planned.all()) {
    const PlannedRuns alone(campaign, run.key);
    ASSERT_EQ(alone.all().size(), 1U) << name_of(run.key);
    const PlannedRun& found = alone.all().front();
    EXPECT_EQ(found.key, run.key);
    EXPECT_EQ(found.job.shown, run.job.shown);
    EXPECT_EQ(found.job.number, run.job.number);
    EXPECT_EQ(found.job.solver, run.job.solver);
    EXPECT_EQ(found.job.perturbation, run.job.perturbation);
    EXPECT_EQ(found.job.problem->name, run.job.problem->name);
    EXPECT_EQ(found.job.problem->instance, run.job.problem->instance);
    EXPECT_EQ(found.job.budget.evaluations, run.job.budget.evaluations);
  }
  RunKey none = planned.all().front().key;
  none.run = 2;
  EXPECT_TRUE(PlannedRuns(campaign, none).all().empty());
  none = planned.all().front().key;
  none.instance = 0;
  EXPECT_TRUE(PlannedRuns(campaign, none).all().empty());
  none = planned.all().front().key;
  none.cell.solver = "another";
  EXPECT_TRUE(PlannedRuns(campaign, none).all().empty());
}

}  // namespace
}  // namespace ricochet
