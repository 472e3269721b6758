#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/experiment/worker.h"

namespace ricochet {
namespace {

/// A bowl with its bottom at 0.3 in every coordinate.
Problem bowl() {
  Problem problem;
  problem.name = "bowl";
  problem.lower = Vector::Zero(3);
  problem.upper = Vector::Ones(3);
  problem.start = Vector::Ones(3);
  problem.evaluate = [](const Vector& x) { return Values{(x.array() - 0.3).square().sum(), {}}; };
  return problem;
}

Solver drawing(std::string name) {
  Solver solver;
  solver.name = std::move(name);
  solver.stochastic = true;
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    while (evaluator.objective(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return SolverTermination{"spent"};
  };
  return solver;
}

struct Jobs {
  std::vector<Problem> problems;
  std::vector<Solver> solvers{drawing("one"), drawing("other")};
  std::vector<Job> jobs;

  explicit Jobs(int instances) {
    for (int i = 0; i < instances; ++i) problems.push_back(instance(bowl(), i));
    for (const Problem& problem : problems) {
      for (const Solver& solver : solvers) jobs.push_back({&problem, &solver, {100}, 0});
    }
  }
};

std::vector<RunRecord> run_on(const std::vector<Job>& jobs, std::size_t at_once) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, at_once);
  std::vector<RunRecord> records(jobs.size());
  run_all(jobs, {}, [&](std::size_t job, RunRecord record) { records[job] = std::move(record); });
  return records;
}

/// Ends this process with 7 and the reason if runs are refused.
[[noreturn]] void run_with_few_open_files(const std::vector<Job>& jobs) {
  int next = 0;  // descriptors below it are open
  while (fcntl(next, F_GETFD) >= 0) ++next;
  // Enough to start a process, too few for what a solver may open there.
  const auto few = static_cast<rlim_t>(next + 10);
  const rlimit limit{few, few};
  setrlimit(RLIMIT_NOFILE, &limit);
  try {
    run_on(jobs, 1);
  } catch (const OutputError& error) {
    std::fputs(error.what(), stderr);
    std::_Exit(7);
  }
  std::_Exit(8);
}

TEST(Runner, StartsNothingWhereTooFewFilesMayBeOpen) {
  const Jobs jobs(1);
  EXPECT_EXIT(run_with_few_open_files(jobs.jobs), testing::ExitedWithCode(7),
              "^too many open files: the limit is ");
}

TEST(Runner, KeepsTheOrderOfTheJobs) {
  const Jobs jobs(20);
  const auto records = run_on(jobs.jobs, 2);
  ASSERT_EQ(records.size(), jobs.jobs.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].solver, jobs.jobs[i].solver->name);
    EXPECT_EQ(records[i].instance, jobs.jobs[i].problem->instance);
  }
}

TEST(Runner, GivesTheSameBitsOnAnyNumberOfProcesses) {
  const Jobs jobs(20);
  const auto one = run_on(jobs.jobs, 1);
  const auto two = run_on(jobs.jobs, 2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].trace.size(), two[i].trace.size());
    for (std::size_t k = 0; k < one[i].trace.size(); ++k) {
      EXPECT_EQ(one[i].trace[k].x, two[i].trace[k].x);
      EXPECT_EQ(one[i].trace[k].true_values.objective, two[i].trace[k].true_values.objective);
      EXPECT_EQ(one[i].trace[k].evaluations, two[i].trace[k].evaluations);
    }
  }
}

TEST(Runner, FinishesTheOtherRunsWhenOneFails) {
  Jobs jobs(3);
  jobs.problems[1].evaluate = [](const Vector&) -> Values { throw std::runtime_error("torn"); };
  const auto records = run_on(jobs.jobs, 2);
  EXPECT_EQ(records[2].failure, "torn");
  EXPECT_EQ(records[3].failure, "torn");
  EXPECT_EQ(records[0].failure, "");
  EXPECT_EQ(records[5].ledger.charged, 100);
}

TEST(Runner, MakesARunAgainWhoseProcessSomebodyHasKilled) {
  Jobs jobs(2);
  const std::filesystem::path mark =
      std::filesystem::path(testing::TempDir()) / fmt::format("ricochet_killed_{}", getpid());
  jobs.solvers[0].solve = [mark](Evaluator& evaluator, const Vector& start, Random&) {
    if (!std::filesystem::exists(mark)) {
      std::ofstream(mark) << "once";
      raise(SIGKILL);
    }
    evaluator.objective(start);
    return SolverTermination{"survived"};
  };
  const auto records = run_on(jobs.jobs, 1);
  std::filesystem::remove(mark);
  for (const RunRecord& record : records) EXPECT_EQ(record.failure, "");
}

TEST(Runner, GivesUpARunThatIsKilledAgain) {
  Jobs jobs(2);
  jobs.solvers[0].solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    raise(SIGKILL);
    return {"never"};
  };
  const auto records = run_on(jobs.jobs, 2);
  for (const RunRecord& record : records) {
    EXPECT_EQ(record.failure, record.solver == "one" ? "crashed: Killed" : "");
  }
}

}  // namespace
}  // namespace ricochet
