#include "src/experiment/planned_runs.h"

#include "src/experiment/worker.h"
#include "tests/support/campaigns.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::ElementsAre;

std::vector<RunKey> keys_of(const PlannedRuns& runs) {
  std::vector<RunKey> keys;
  for (const PlannedRun& run : runs.all()) keys.push_back(run.key);
  return keys;
}

TEST(PlannedRuns, OfShardsAreDisjointAndCompleteWhateverIsDone) {
  const Campaign campaign = made_up_campaign(part_of(
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
      std::vector<RunKey> left;
      for (const RunKey& key : all) {
        EXPECT_TRUE(seen.insert(key).second) << name_of(key);
        if (!done.contains(key)) left.push_back(key);
      }
      EXPECT_EQ(keys_of(PlannedRuns(campaign, {index, count}, done)), left);
    }
    EXPECT_EQ(seen, every) << count;
  }
}

TEST(PlannedRuns, BeginAtThePlansFirstInstance) {
  const std::string parts = part_of("\"bowl-1\"", "instances = 2");
  const Campaign later = made_up_campaign("first_instance = 4\n" + parts);
  const Campaign first = made_up_campaign(parts);
  std::set<int> instances;
  const PlannedRuns planned(later, {}, {});
  for (const PlannedRun& run : planned.all()) {
    instances.insert(run.key.instance);
    EXPECT_EQ(run.job.problem->instance, run.key.instance);
    EXPECT_TRUE(later.has(run.key));
    EXPECT_FALSE(first.has(run.key));
  }
  EXPECT_THAT(instances, ElementsAre(4, 5));
  EXPECT_EQ(later.runs(), 2);
}

TEST(PlannedRuns, BeginWithTheLongest) {
  const Campaign campaign = made_up_campaign(part_of("\"bowl-*\"", "budgets = [5, 50]"));
  const PlannedRuns planned(campaign, {}, {});
  EXPECT_TRUE(std::is_sorted(planned.all().begin(), planned.all().end(),
                             [](const auto& a, const auto& b) { return a.length > b.length; }));
  EXPECT_EQ(planned.all().front().length, 8.0 * 8 * 50);
}

TEST(PlannedRuns, HaveTheirBestPointWhereTheOptimumIsRelocated) {
  const Campaign campaign = made_up_campaign(part_of("\"bowl-2\"", "relocated_optimum = true"));
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

/// All but the problem, which each PlannedRuns makes anew.
auto contents(const PlannedRun& run) {
  const Job& job = run.job;
  return std::tuple(run.key, job.problem->name, job.problem->instance, job.solver, job.perturbation,
                    job.shown, job.number, job.budget.evaluations);
}

const std::string of_all_kinds =
    "solvers = \"*\"\nperturbations = [\"plain\", \"noisy\"]\ninstances = 2\nseeds = 2";

TEST(PlannedRuns, AreSeededByAllThatTheyAreCalled) {
  const Campaign campaign = made_up_campaign(part_of("\"cup-s\"", of_all_kinds));
  const PlannedRuns planned(campaign, {}, {});
  std::vector<Job> jobs;
  for (const PlannedRun& run : planned.all()) jobs.push_back(run.job);
  std::set<std::uint64_t> seeds;
  run_all(jobs, {}, [&](std::size_t j, const RunRecord& record) {
    const RunKey& key = planned.all()[j].key;
    EXPECT_TRUE(seeds.insert(record.seed).second) << name_of(key);
    EXPECT_EQ(std::tuple(record.instance, record.run), std::tuple(key.instance, key.run));
  });
  EXPECT_EQ(static_cast<std::int64_t>(seeds.size()), campaign.runs());
}

TEST(PlannedRuns, AreFoundOneByOneAsTheyAreAmongAll) {
  const Campaign campaign = made_up_campaign(part_of("\"*\"", of_all_kinds));
  const PlannedRuns planned(campaign, {}, {});
  for (const PlannedRun& run : planned.all()) {
    const PlannedRuns alone(campaign, run.key);
    ASSERT_EQ(alone.all().size(), 1U) << name_of(run.key);
    EXPECT_EQ(contents(alone.all().front()), contents(run));
  }
  RunKey further = planned.all().front().key, before = further, strange = further;
  further.run = 2;
  before.instance = 0;
  strange.cell.solver = "another";
  for (const RunKey& none : {further, before, strange}) {
    EXPECT_TRUE(PlannedRuns(campaign, none).all().empty());
  }
}

TEST(ProblemHash, DependsOnAllThatAScoreRestsOn) {
  const std::function<void(Problem&)> changes[] = {
      [](Problem&) {},
      [](Problem& q) { q.name = "another"; },
      [](Problem& q) { q.upper[0] = std::nextafter(1.0, 2.0); },
      [](Problem& q) { q.start[0] = 0.8; },
      [](Problem& q) { q.tolerance = 1e-5; },
      [](Problem& q) { q.penalty_weight = 2; },
      [](Problem& q) { q.smoothed = [q](double) { return q; }; },
      [](Problem& q) { q.rotates = true; },
      [](Problem& q) { q.best_known = std::numeric_limits<double>::min(); },
      [](Problem& q) { q.best_point = Vector::Constant(2, 0.25); },
      [](Problem& q) {
        q.evaluate = [](const Vector& x) { return Values{x.squaredNorm(), Vector()}; };
      },
      [](Problem& q) {
        q.true_values = [](const Vector&) -> TrueValues { throw std::runtime_error("none"); };
      }};
  std::set<std::string> hashes;
  for (const auto& change : changes) {
    Problem problem = bowl("bowl", 2);
    change(problem);
    const std::string hash = problem_hash(problem);
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(problem_hash(problem), hash);
    hashes.insert(hash);
  }
  EXPECT_EQ(hashes.size(), std::size(changes));
}

class Completenesses : public TemporaryFolder {
 protected:
  /// Of a store that has those of the campaign's runs, in the order of their lengths, that `keeps`
  /// returns true for; the first of them failed.
  Completeness with(const Campaign& campaign, const std::function<bool(std::size_t)>& keeps) {
    std::filesystem::remove(file_);
    const PlannedRuns planned(campaign, {}, {});
    Store::write(file_, campaign.description(), [&](const Store::AddRun& add) {
      for (std::size_t k = 0; k < planned.all().size(); ++k) {
        RunRecord record;
        record.failure = k == 0 ? "it failed" : "";
        if (keeps(k)) add(planned.all()[k].key, record);
      }
    });
    return completeness_of(campaign, Store::open(file_, Store::For::reading));
  }

  const std::filesystem::path file_ = folder_ / "runs.sqlite";
  const Campaign campaign_ = made_up_campaign(
      part_of("\"bowl-[12]\"", "name = \"one\"\nsolvers = \"chance-*\"\ninstances = 3") +
      part_of("\"bowl-8\"", "name = \"other\"\ninstances = 3\nseeds = 2"));
};

TEST_F(Completenesses, CountRunsThatFailedAsPresent) {
  const Completeness whole = with(campaign_, [](std::size_t) { return true; });
  EXPECT_EQ(whole.planned, 2 * 2 * 3 + 3 * 2);
  EXPECT_EQ(whole.missing(), 0);
  EXPECT_FALSE(whole.is_in_doubt());
  EXPECT_EQ(in_words(whole), "all 18 planned runs are present");
}

TEST_F(Completenesses, NameMissingShards) {
  const Completeness found = with(campaign_, [](std::size_t k) { return k % 4 == 2; });
  EXPECT_EQ(found.present, 4);
  EXPECT_EQ(found.missing(), 14);
  EXPECT_EQ(found.missing_shards, "shards 1, 2, 4 of 4");
  EXPECT_EQ(with(campaign_, [](std::size_t k) { return k % 3 != 1; }).missing_shards,
            "shard 2 of 3");
  const Completeness none = with(campaign_, [](std::size_t) { return false; });
  EXPECT_EQ(none.missing(), 18);
  EXPECT_EQ(none.missing_shards, "");
}

TEST_F(Completenesses, SayOfWhatRunsAreMissingAfterAnInterruption) {
  const Completeness found = with(campaign_, [](std::size_t k) { return k < 12; });
  EXPECT_EQ(found.missing_shards, "") << "the longest runs are there";
  EXPECT_THAT(found.missing_problems, ElementsAre("bowl-1"));
  EXPECT_THAT(found.missing_solvers, ElementsAre("chance-a", "chance-b"));
  EXPECT_THAT(found.missing_instances, ElementsAre(1, 2, 3));
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(found.parts[0].present, 6);
  EXPECT_EQ(found.parts[1].present, 6);
  EXPECT_EQ(
      in_words(found),
      "12 of 18 planned runs are present, 6 are missing: of bowl-1; of chance-a, chance-b; on "
      "instances 1, 2, 3; 6 of 12 of one");
  const Campaign many = made_up_campaign(part_of("\"bowl-1\"", "instances = 9"));
  EXPECT_THAT(in_words(with(many, [](std::size_t k) { return k == 0; })),
              testing::HasSubstr("on instances 2, 3, 4, 5, 6 and 3 more"));
}

TEST_F(Completenesses, DoubtSolversThatThisBuildLacks) {
  with(campaign_, [](std::size_t) { return true; });
  const Campaign smaller =
      made_up_campaign(part_of("\"bowl-[12]\"", "solvers = \"chance-a\"\ninstances = 3"));
  const Completeness found = completeness_of(smaller, Store::open(file_, Store::For::reading));
  EXPECT_EQ(found.missing(), 0);
  EXPECT_TRUE(found.is_in_doubt());
  EXPECT_EQ(
      in_words(found),
      "all 18 planned runs are present; further runs of chance-b may be missing: this build has "
      "no such solver");
}

}  // namespace
}  // namespace ricochet
