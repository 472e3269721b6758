#include "src/experiment/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "ricochet/error.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// (x - 0.3)^2 on [0, 1], from 1.
Problem valley() {
  Problem problem;
  problem.name = "valley";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Ones(1);
  problem.start = Vector::Ones(1);
  problem.evaluate = [](const Vector& x) { return Values{std::pow(x[0] - 0.3, 2), {}}; };
  return problem;
}

/// Asks for 0.5, where the valley is better than at its start, and then does something else.
Solver that(std::function<void()> does) {
  Solver solver;
  solver.name = "that";
  solver.solve = [does](Evaluator& evaluator, const Vector&, Random&) -> SolverTermination {
    evaluator.objective(Vector::Constant(1, 0.5));
    does();
    return {"done", Vector::Constant(1, 0.25)};
  };
  return solver;
}

/// Its run, and that of a harmless one after it.
std::vector<RunRecord> records_of(const Problem& problem, const Solver& solver, Limits limits) {
  const Solver harmless = that([] {});
  const std::vector<Job> jobs = {{&problem, &solver, {20}, 3}, {&problem, &harmless, {20}, 0}};
  std::vector<RunRecord> records(jobs.size());
  run_all(jobs, limits, [&](std::size_t job, RunRecord record) { records[job] = record; });
  return records;
}

/// What has become of a run that did this; the harmless one is never touched.
RunRecord run_that(const std::function<void()>& does, Limits limits = {60, 256}) {
  const Problem problem = valley();
  const auto records = records_of(problem, that(does), limits);
  EXPECT_THAT(records[1].failure, IsEmpty());
  EXPECT_EQ(records[1].ledger.charged, 20);
  EXPECT_EQ(records[1].terminations.size(), 21U);
  return records[0];
}

/// Whose run failed, which keeps what it had found and is charged all.
void expect_failed(const RunRecord& record, const testing::Matcher<std::string>& failure) {
  EXPECT_THAT(record.failure, failure);
  ASSERT_EQ(record.trace.size(), 1U);
  EXPECT_EQ(record.trace[0].x[0], 0.5);
  EXPECT_DOUBLE_EQ(record.trace[0].true_values.objective, 0.04);
  EXPECT_EQ(record.solver, "that");
  EXPECT_EQ(record.problem, "valley");
  EXPECT_EQ(record.run, 3);
}

TEST(Worker, BringsBackTheRecordOfARun) {
  const Problem problem = valley();
  const Solver solver = that([] {});
  const RunRecord here = run(problem, solver, {20}, 3);
  const RunRecord there = records_of(problem, solver, {})[0];
  EXPECT_EQ(there.seed, here.seed);
  EXPECT_EQ(there.terminations, here.terminations);
  EXPECT_EQ(there.ledger.charged, here.ledger.charged);
  ASSERT_TRUE(there.returned);
  EXPECT_EQ(there.returned->x, here.returned->x);
  EXPECT_EQ(there.returned->true_values.objective, here.returned->true_values.objective);
  ASSERT_EQ(there.trace.size(), here.trace.size());
  EXPECT_EQ(there.trace[0].true_values.objective, here.trace[0].true_values.objective);
}

TEST(Worker, SurvivesASolverThatThrows) {
  expect_failed(run_that([] { throw std::runtime_error("torn"); }), StartsWith("torn"));
  expect_failed(run_that([] { throw 7; }), HasSubstr("not a std::exception"));
}

TEST(Worker, SurvivesASolverThatCrashes) {
  const RunRecord killed = run_that([] { kill(getpid(), SIGKILL); });
  expect_failed(killed, StartsWith("crashed: Killed"));
  EXPECT_EQ(killed.ledger.charged, 20);
  expect_failed(run_that([] { raise(SIGSEGV); }), testing::Not(IsEmpty()));
  expect_failed(run_that([] { _exit(3); }), HasSubstr("exit status 3"));
  expect_failed(run_that([] { _exit(0); }), HasSubstr("exit status 0"));
}

/// If that is shorter than the limit of the plan.
TEST(Worker, KillsARunAfterTheLongestTimeOfItsProblem) {
  const Solver hanging = that([] { std::this_thread::sleep_for(std::chrono::hours(1)); });
  Problem problem = valley();
  problem.longest_run = 0.3;
  EXPECT_THAT(records_of(problem, hanging, {60, 256})[0].failure,
              StartsWith("killed: it took more than 0.3 s"));
  problem.longest_run = 60;
  EXPECT_THAT(records_of(problem, hanging, {0.2, 256})[0].failure,
              StartsWith("killed: it took more than 0.2 s"));
}

TEST(Worker, KillsASolverThatHangs) {
  const Limits soon{0.3, 256};
  expect_failed(run_that([] { std::this_thread::sleep_for(std::chrono::hours(1)); }, soon),
                StartsWith("killed: it took more than 0.3 s"));
  volatile bool always = true;
  expect_failed(run_that(
                    [&] {
                      while (always) {
                      }
                    },
                    soon),
                StartsWith("killed: it took more than 0.3 s"));
}

TEST(Worker, KillsWhatAHangingSolverHasStarted) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  run_that(
      [&] {
        if (fork() == 0) std::this_thread::sleep_for(std::chrono::hours(1));
        std::this_thread::sleep_for(std::chrono::hours(1));
      },
      {0.3, 256});
  close(ends[1]);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0) << "nobody holds the other end any more";
  close(ends[0]);
}

TEST(Worker, GivesASolverNoMoreMemoryThanAllowed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers' own memory knows no limit";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "the sanitizers' own memory knows no limit";
#endif
#endif
  const auto eats = [] {
    std::vector<std::unique_ptr<char[]>> meals;
    for (int k = 0; k < 30; ++k) meals.push_back(std::make_unique<char[]>(1 << 20));
  };
  expect_failed(run_that(eats, {60, 16}), StartsWith("out of memory"));
  const auto does_not_look = [] {
    for (int k = 0; k < 30; ++k) {
      static_cast<volatile char*>(std::malloc(1 << 20))[0] = 1;
    }
  };
  expect_failed(run_that(does_not_look, {60, 16}), StartsWith("crashed: "));
  EXPECT_THAT(run_that(eats, {60, 200}).failure, IsEmpty());
}

TEST(Worker, MakesARunAgainWhereAnotherMayHaveSpoiltTheProcess) {
  const Problem problem = valley();
  static int runs = 0;
  const Solver spoils = that([] { ++runs; });
  const Solver suffers = that([] {
    if (runs > 0) _exit(9);
  });
  const std::vector<Job> jobs = {{&problem, &spoils, {1}}, {&problem, &suffers, {1}}};
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<RunRecord> records(2);
  run_all(jobs, {}, [&](std::size_t job, RunRecord record) { records[job] = record; });
  EXPECT_THAT(records[0].failure, IsEmpty());
  EXPECT_THAT(records[1].failure, IsEmpty());
  EXPECT_EQ(records[1].terminations.size(), 2U);
}

TEST(Worker, KeepsWhatASolverPrintsOutOfTheResults) {
  testing::internal::CaptureStdout();
  EXPECT_THAT(run_that([] {
                std::printf("found it!\n");
                std::fflush(stdout);
              }).failure,
              IsEmpty());
  EXPECT_THAT(testing::internal::GetCapturedStdout(), IsEmpty());
}

TEST(Worker, KeepsNumbersThatAreNone) {
  Problem problem = valley();
  problem.evaluate = [](const Vector& x) {
    return Values{-std::numeric_limits<double>::infinity() * x[0], {}};
  };
  const auto records = records_of(problem, that([] {}), {});
  ASSERT_EQ(records[0].trace.size(), 1U);
  EXPECT_EQ(records[0].trace[0].true_values.objective, -std::numeric_limits<double>::infinity());
}

TEST(Worker, RefusesLimitsThatAreNone) {
  EXPECT_NO_THROW(check({}));
  EXPECT_THROW(check({0, 1}), InputError);
  EXPECT_THROW(check({std::nan(""), 1}), InputError);
  EXPECT_THROW(check({1, -1}), InputError);
}

TEST(Worker, DoesNotOutliveWhatWasThrownOutside) {
  const Problem problem = valley();
  const Solver sleeps = that([] { std::this_thread::sleep_for(std::chrono::hours(1)); });
  const Solver harmless = that([] {});
  const std::vector<Job> jobs = {{&problem, &harmless, {20}}, {&problem, &sleeps, {20}}};
  EXPECT_THROW(run_all(jobs, {}, [](std::size_t, const RunRecord&) { throw std::bad_alloc(); }),
               std::bad_alloc);
}

}  // namespace
}  // namespace ricochet
