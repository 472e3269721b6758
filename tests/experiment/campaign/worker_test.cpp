#include "src/experiment/worker.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <csignal>

#include "src/core/files.h"
#include "tests/support/campaigns.h"
#include "tests/support/files.h"
#include "tests/support/pipe.h"
#include "tests/support/refusals.h"

namespace ricochet {
namespace {

const Problem valley = bowl("valley", 1);

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

void sleep_for_an_hour() {
  std::this_thread::sleep_for(std::chrono::hours(1));
}

std::vector<RunRecord> records_of(const std::vector<Job>& jobs, const Limits& limits = {}) {
  std::vector<RunRecord> records(jobs.size());
  run_all(jobs, limits, [&](std::size_t job, RunRecord record) { records[job] = record; });
  return records;
}

/// What has become of a run of this solver; a harmless one after it is never touched.
RunRecord record_of(const Problem& problem, const Solver& solver,
                    const Limits& limits = {60, 256}) {
  const Solver harmless = that([] {});
  const auto records =
      records_of({{&problem, &solver, {20}, 3}, {&valley, &harmless, {20}, 0}}, limits);
  EXPECT_THAT(records[1].failure, IsEmpty());
  EXPECT_EQ(records[1].ledger.charged, 20);
  EXPECT_EQ(records[1].terminations.size(), 21U);
  return records[0];
}

/// Of a run that did this, which keeps what it had found and is charged all.
std::string failure_of(const std::function<void()>& does, const Limits& limits = {60, 256}) {
  const RunRecord record = record_of(valley, that(does), limits);
  EXPECT_EQ(record.trace.size(), 1U);
  EXPECT_EQ(record.trace.at(0).x[0], 0.5);
  EXPECT_DOUBLE_EQ(record.trace.at(0).true_values.objective, 0.04);
  EXPECT_EQ(std::tuple(record.solver, record.problem, record.run), std::tuple("that", "valley", 3));
  return record.failure;
}

TEST(Worker, SurvivesASolverOrAProblemThatThrowsOrCrashes) {
  EXPECT_THAT(failure_of([] { throw std::runtime_error("torn"); }), StartsWith("torn"));
  EXPECT_THAT(failure_of([] { throw 7; }), HasSubstr("not a std::exception"));
  EXPECT_THAT(failure_of([] { raise(SIGSEGV); }), Not(IsEmpty()));
  EXPECT_THAT(failure_of([] { _exit(3); }), HasSubstr("exit status 3"));
  EXPECT_THAT(failure_of([] { _exit(0); }), HasSubstr("exit status 0"));
  const RunRecord killed = record_of(valley, that([] { kill(getpid(), SIGKILL); }));
  EXPECT_THAT(killed.failure, StartsWith("crashed: Killed")) << "again, as it is made once more";
  EXPECT_EQ(killed.ledger.charged, 20);
  Problem torn = valley;
  torn.evaluate = [](const Vector&) -> Values { throw std::runtime_error("torn"); };
  EXPECT_EQ(record_of(torn, that([] {})).failure, "torn");
}

/// Of the limits of the plan and of the problem the shorter one holds.
TEST(Worker, KillsASolverThatHangsWithAllThatItHasStarted) {
  const Limits soon{0.3, 256};
  const std::string said = "killed: it took more than 0.3 s";
  Pipe held;
  const auto starts_another = [] {
    if (fork() == 0) sleep_for_an_hour();
    sleep_for_an_hour();
  };
  EXPECT_THAT(failure_of(starts_another, soon), StartsWith(said));
  EXPECT_TRUE(held.is_held_by_nobody()) << "the other is gone, too";
  volatile bool always = true;
  const auto is_busy = [&] {
    while (always) continue;
  };
  EXPECT_THAT(failure_of(is_busy, soon), StartsWith(said));
  Problem problem = valley;
  problem.longest_run = 0.3;
  EXPECT_THAT(record_of(problem, that(sleep_for_an_hour)).failure, StartsWith(said));
  problem.longest_run = 60;
  EXPECT_THAT(record_of(problem, that(sleep_for_an_hour), soon).failure, StartsWith(said));
}

TEST(Worker, GivesASolverNoMoreMemoryThanAllowed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers' own memory knows no limit";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "the sanitizers' own memory knows no limit";
#endif
#endif
  // More than the tests before may have left in this process.
  const auto eats = [] {
    std::vector<std::unique_ptr<char[]>> meals;
    for (int k = 0; k < 150; ++k) meals.push_back(std::make_unique<char[]>(1 << 20));
  };
  EXPECT_THAT(failure_of(eats, {60, 16}), StartsWith("out of memory"));
  const auto does_not_look = [] {
    for (int k = 0; k < 150; ++k) static_cast<volatile char*>(std::malloc(1 << 20))[0] = 1;
  };
  EXPECT_THAT(failure_of(does_not_look, {60, 16}), StartsWith("crashed: "));
  EXPECT_THAT(failure_of(eats, {60, 200}), IsEmpty());
}

TEST(Worker, MakesARunAgainWhereAnotherMayHaveSpoiltTheProcess) {
  static int runs = 0;
  const Solver spoils = that([] { ++runs; });
  const Solver suffers = that([] {
    if (runs > 0) _exit(9);
  });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto records = records_of({{&valley, &spoils, {1}}, {&valley, &suffers, {1}}});
  EXPECT_THAT(records, Each(testing::Field(&RunRecord::failure, "")));
  EXPECT_EQ(records[1].terminations.size(), 2U);
}

TEST(Worker, KeepsWhatASolverPrintsOutOfTheResults) {
  const auto prints = [] {
    std::printf("found it!\n");
    std::fflush(stdout);
  };
  testing::internal::CaptureStdout();
  EXPECT_THAT(record_of(valley, that(prints)).failure, IsEmpty());
  EXPECT_THAT(testing::internal::GetCapturedStdout(), IsEmpty());
}

TEST(Worker, RefusesLimitsThatAreNone) {
  EXPECT_NO_THROW(check({}));
  for (const auto& limits : {Limits{0, 1}, {quiet_nan, 1}, {1, -1}})
    EXPECT_THROW(check(limits), InputError);
}

TEST(Worker, DoesNotOutliveWhatWasThrownOutside) {
  const Solver sleeps = that(sleep_for_an_hour);
  const Solver harmless = that([] {});
  const std::vector<Job> jobs = {{&valley, &harmless, {20}}, {&valley, &sleeps, {20}}};
  EXPECT_THROW(run_all(jobs, {}, [](std::size_t, const RunRecord&) { throw std::bad_alloc(); }),
               std::bad_alloc);
}

/// Ends this process with 7 and the reason if runs are refused.
[[noreturn]] void run_with_few_open_files() {
  int next = 0;  // descriptors below it are open
  while (fcntl(next, F_GETFD) >= 0) ++next;
  // Enough to start a process, too few for what a solver may open there.
  const auto few = static_cast<rlim_t>(next) + 10;
  const rlimit limit{few, few};
  setrlimit(RLIMIT_NOFILE, &limit);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Solver solver = chance("any");
  const auto run = [&] { return records_of({{&valley, &solver, {20}}}); };
  std::fputs(complaint_of<OutputError>(run).c_str(), stderr);
  std::_Exit(7);
}

TEST(Runner, StartsNothingWhereTooFewFilesMayBeOpen) {
  EXPECT_EXIT(run_with_few_open_files(), testing::ExitedWithCode(7),
              "^too many open files: the limit is ");
}

TEST(Runner, BringsTheRecordsOfThisProcessInOrderFromAnyNumberOfOthers) {
  std::vector<Problem> problems;
  for (int i = 0; i < 20; ++i) problems.push_back(instance(bowl("bowl", 3), i));
  const Solver solvers[] = {chance("one"), chance("other")};
  std::vector<Job> jobs;
  for (const Problem& problem : problems) {
    for (const Solver& solver : solvers) jobs.push_back({&problem, &solver, {100}, 0});
  }
  for (const std::size_t processes : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, processes);
    const auto records = records_of(jobs);
    for (std::size_t i = 0; i < 40; ++i) {
      const RunRecord here = run(*jobs[i].problem, *jobs[i].solver, jobs[i].budget, 0);
      EXPECT_EQ(bits_of(without_times(records.at(i))), bits_of(without_times(here)));
    }
  }
}

using RunnerInAFolder = TemporaryFolder;

TEST_F(RunnerInAFolder, MakesARunAgainWhoseProcessSomebodyHasKilled) {
  const auto is_killed_once = [mark = folder_ / "killed"] {
    if (fs::exists(mark)) return;
    write_file(mark, "once");
    raise(SIGKILL);
  };
  EXPECT_EQ(record_of(valley, that(is_killed_once)).failure, "");
}

/// A message keeps that a number is none, but not which of those.
std::string with_one_nan(std::string bits) {
  const std::size_t length = bits_of(std::nan("")).size();
  for (std::size_t at = 0; (at = bits.find("nan = ", at)) != std::string::npos;) {
    bits.replace(at, length, "none ");
  }
  return bits;
}

TEST(RecordText, KeepsEveryBitOfARecordAndOfAnImprovement) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    RunRecord record = any::record(random);
    record.problem = "valley \"of\" \n tears";
    record.solver = "mine";
    record.failure = k % 2 == 0 ? "torn" : "";
    for (SolverTermination& end : record.terminations) {
      end.reason = "done";
      if (k % 3 == 0) end.point.reset();
    }
    if (k % 3 == 0) record.budget.gradient_price = k % 2;
    const auto bits = bits_of(record), again = bits_of(record_from(text_of(record)));
    EXPECT_EQ(with_one_nan(fmt::to_string(fmt::join(again, "\n"))),
              with_one_nan(fmt::to_string(fmt::join(bits, "\n"))));
    const Improvement step{any::count(random), any::number(random), any::true_values(random),
                           any::point(random)};
    EXPECT_EQ(with_one_nan(bits_of(improvement_from(text_of(step)))), with_one_nan(bits_of(step)));
  }
}

TEST(RecordText, RefusesWhatIsNone) {
  EXPECT_ANY_THROW(record_from(""));
  EXPECT_ANY_THROW(record_from("{}"));
  EXPECT_ANY_THROW(improvement_from("\x83\x01\x02\x03"));
}

}  // namespace
}  // namespace ricochet
