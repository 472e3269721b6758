#include "src/experiment/planned_runs.h"

#include "ricochet/evaluator.h"
#include "src/core/time_limit.h"
#include "tests/support/campaigns.h"
#include "tests/support/files.h"
#include "tests/support/pipe.h"

namespace ricochet {
namespace {

std::vector<RunKey> keys_of(const PlannedRuns& runs) {
  std::vector<RunKey> keys;
  for (const PlannedRun& run : runs.all()) keys.push_back(run.key);
  return keys;
}

TEST(PlannedRuns, BeginWithTheLongestAndAreDisjointAndCompleteInShardsWhateverIsDone) {
  const Campaign campaign = made_up_campaign(part_of(
      "\"*\"",
      "solvers = \"*\"\nperturbations = \"*\"\ninstances = 4\nseeds = 2\nbudgets = [3, 7]"));
  const PlannedRuns planned(campaign, {}, {});
  EXPECT_TRUE(std::ranges::is_sorted(planned.all(), std::greater(), &PlannedRun::length));
  EXPECT_EQ(planned.all().front().length, 8.0 * 8 * 7);
  const auto whole = keys_of(planned);
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
  const std::string part = part_of("\"bowl-1\"", "instances = 2");
  const Campaign later = made_up_campaign("first_instance = 4\n" + part);
  const Campaign first = made_up_campaign(part);
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
  /// What is said of a store that has those of the campaign's runs, in the order of their lengths,
  /// that `keeps` returns true for; the first of them failed.
  std::string said(const Campaign& campaign, const std::function<bool(std::size_t)>& keeps) {
    fs::remove(file_);
    const PlannedRuns planned(campaign, {}, {});
    Store::write(file_, campaign.description(), [&](const Store::AddRun& add) {
      for (std::size_t k = 0; k < planned.all().size(); ++k) {
        RunRecord record;
        record.failure = k == 0 ? "it failed" : "";
        if (keeps(k)) add(planned.all()[k].key, record);
      }
    });
    return said(campaign);
  }

  std::string said(const Campaign& campaign) const {
    const Completeness found = completeness_of(campaign, Store::open(file_, Store::For::reading));
    EXPECT_EQ(found.is_in_doubt(), in_words(found).find("missing") != std::string::npos);
    return in_words(found);
  }

  const fs::path file_ = folder_ / "runs.sqlite";
  const Campaign campaign_ = made_up_campaign(
      part_of("\"bowl-[12]\"", "name = \"one\"\nsolvers = \"chance-*\"\ninstances = 3") +
      part_of("\"bowl-8\"", "name = \"other\"\ninstances = 3\nseeds = 2"));
};

TEST_F(Completenesses, SayOfWhatRunsAreMissing) {
  const std::string of_any =
      "of bowl-1, bowl-2, bowl-8; of chance-a, chance-b; on instances 1, 2, 3";
  struct Kept {
    std::function<bool(std::size_t)> keeps;
    std::string said;
  };
  const std::vector<Kept> all = {
      {[](auto) { return true; }, "all 18 planned runs are present"},
      {[](auto) { return false; }, "0 of 18 planned runs are present, 18 are missing: " + of_any +
                                       "; 0 of 12 of one; 0 of 6 of other"},
      {[](auto k) { return k % 4 == 2; },
       "4 of 18 planned runs are present, 14 are missing: shards 1, 2, 4 of 4; " + of_any +
           "; 3 of 12 of one; 1 of 6 of other"},
      {[](auto k) { return k % 3 != 1; },
       "12 of 18 planned runs are present, 6 are missing: shard 2 of 3; " + of_any +
           "; 8 of 12 of one; 4 of 6 of other"},
      {[](auto k) { return k < 12; },  // the longest
       "12 of 18 planned runs are present, 6 are missing: of bowl-1; of chance-a, chance-b; on "
       "instances 1, 2, 3; 6 of 12 of one"}};
  for (const auto& [keeps, words] : all) EXPECT_EQ(said(campaign_, keeps), words);
  const Campaign many = made_up_campaign(part_of("\"bowl-1\"", "instances = 9"));
  EXPECT_THAT(said(many, [](std::size_t k) { return k == 0; }),
              HasSubstr("on instances 2, 3, 4, 5, 6 and 3 more"));
}

TEST_F(Completenesses, DoubtSolversThatThisBuildLacks) {
  said(campaign_, [](std::size_t) { return true; });
  EXPECT_EQ(
      said(made_up_campaign(part_of("\"bowl-[12]\"", "solvers = \"chance-a\"\ninstances = 3"))),
      "all 18 planned runs are present; further runs of chance-b may be missing: this build has "
      "no such solver");
}

/// Processor time [s] that is burnt.
void burn(double seconds) {
  const double end = processor_seconds() + seconds;
  while (processor_seconds() < end) continue;
}

/// The same values after so long.
auto slowed(const std::function<Values(const Vector&)>& evaluate, double seconds) {
  return [evaluate, seconds](const Vector& x) { return burn(seconds), evaluate(x); };
}

/// A catalogue whose first problem and solver can be changed.
struct Changed {
  Catalogue catalogue = made_up_catalogue();
  Problem& problem = catalogue.families[0].problems[0];
  Solver& solver = catalogue.solvers[0];

  Forecast forecast(const std::string& rest, const std::string& problems = "\"bowl-1\"") const {
    return forecast_of(made_up_campaign(part_of(problems, rest), catalogue));
  }
};

/// Of a problem that takes so long for each evaluation, and of a solver between them.
Forecast foretold(double simulation, double between, const std::string& rest) {
  Changed changed;
  changed.problem.evaluate = slowed(changed.problem.evaluate, simulation);
  changed.solver.solve = [between](Evaluator& evaluator, const Vector& start, Random&) {
    while (evaluator.objective(start)) burn(between);
    return SolverTermination{"spent"};
  };
  return changed.forecast(rest);
}

TEST(Forecast, IsTheTimeOfSimulationsAndOfTheSolver) {
  // Half a millisecond and a quarter for each of 10 runs of 20 and of 2000 evaluations.
  const double seconds =
      foretold(5e-4, 2.5e-4, "budgets = [20, 2000]\ninstances = 5\nseeds = 2").runs;
  EXPECT_GT(seconds, 10 * 2020 * 7.0e-4);
  EXPECT_LT(seconds, 10 * 2020 * 1.2e-3);
}

TEST(Forecast, HasItsShareForEveryRun) {
  const Forecast many = foretold(0, 0, "budgets = 2\ninstances = 10000");
  EXPECT_GT(many.runs, 0.1) << "ten thousand processes' messages and rows of a store";
  const Forecast few = foretold(0, 0, "budgets = 2\ninstances = 100");
  EXPECT_GT(many.runs, 10 * few.runs) << "100 times as many, each measured on a busy machine";
  EXPECT_GT(many.report, 1.5 * few.report);
  EXPECT_GT(few.one_core, 0);
}

TEST(Forecast, HasEveryEvaluationThatTheScorerMakes) {
  // The least of three: other work of the machine only adds.
  const auto least_of_three = [](const std::string& perturbation) {
    double seconds = infinity;
    for (int k = 0; k < 3; ++k) {
      const std::string part =
          "budgets = 100\ninstances = 10\nperturbations = \"" + perturbation + "\"";
      seconds = std::min(seconds, foretold(5e-4, 0, part).runs);
    }
    return seconds;
  };
  EXPECT_NEAR(least_of_three("noisy") / least_of_three("plain"), 2, 0.4);
}

TEST(Forecast, HasTheStartOfASolverOnceForEveryProcess) {
  Changed changed;
  changed.solver.solve = [solve = changed.solver.solve, started = std::make_shared<bool>(false)](
                             Evaluator& evaluator, const Vector& start, Random& random) {
    if (!std::exchange(*started, true)) burn(0.05);
    return solve(evaluator, start, random);
  };
  const Forecast forecast = changed.forecast("budgets = 2\ninstances = 100");
  EXPECT_GT(forecast.runs, 0.05);
  EXPECT_LT(forecast.runs, 100 * 0.05 / 2) << "not for every run, though on a busy machine";
}

TEST(Forecast, HasTheSearchForBestValues) {
  Changed changed;
  Problem slow = bowl("bowl-slow", 1);
  slow.scan_step = 1e-3;
  slow.evaluate = slowed(slow.evaluate, 5e-4);
  changed.catalogue.grid_problems = [slow](const MachineGrid&) {
    return std::vector{searched(slow, nullptr)};
  };
  const Forecast forecast =
      changed.forecast("machines = { around = \"C1\" }\nbudgets = 2\ninstances = 1", "\"*\"");
  EXPECT_GE(forecast.search, 0.49) << "1000 steps of at least 0.5 ms";
  EXPECT_LT(forecast.search, 5) << "a busy machine takes longer, but not so much";
}

TEST(Forecast, IsALowerLimitWhereASolverCannotBeTimed) {
  Changed changed;
  const std::string both = "solvers = [\"chance-a\", \"chance-b\"]\nbudgets = 2";
  EXPECT_FALSE(changed.forecast(both).at_least);
  changed.solver.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::runtime_error("not started");
  };
  EXPECT_TRUE(changed.forecast(both).at_least);
}

TEST(Forecast, SharesAllButThePagesAmongCores) {
  const Forecast forecast{4, 10, 2.25};
  EXPECT_NEAR(forecast.seconds(1), 16.25, 0.1);
  EXPECT_NEAR(forecast.seconds(4), 4.25, 0.25);
}

TEST(Forecast, ShowsItsProgressOnATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "there is no /dev/pts";
  EXPECT_THAT(shown_on_terminal([] { foretold(0, 0, "budgets = 2"); }),
              HasSubstr("timing problems"));
}

TEST(Forecast, OutlivesAProblemThatThrows) {
  Changed changed;
  changed.problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("ill"); };
  EXPECT_GT(changed.forecast("budgets = 5").runs, 0);
}

/// It does not evaluate the problem in this process, and expects that its runs hang.
TEST(Forecast, OutlivesAProblemThatHangs) {
  Changed changed;
  changed.problem.hazardous = true;
  changed.problem.longest_run = 2;
  changed.problem.evaluate = [](const Vector&) -> Values { std::abort(); };
  changed.problem.true_values = [](const Vector&) { return TrueValues{}; };
  const Forecast forecast =
      changed.forecast("budgets = 5\ninstances = 3", "[\"bowl-1\", \"bowl-2\"]");
  EXPECT_GT(forecast.runs, 6);
  EXPECT_LT(forecast.runs, 7);
  EXPECT_FALSE(forecast.at_least);
}

}  // namespace
}  // namespace ricochet
