#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "solvers/library_solvers.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// What a solver asked for, and where.
struct Asked {
  std::string kind;
  Vector x;

  bool operator==(const Asked&) const = default;
};

void PrintTo(const Asked& asked, std::ostream* stream) {
  *stream << asked.kind << " " << asked.x.transpose();
}

using Log = std::vector<Asked>;

Solver solver_of(const std::string& name) {
  for (Solver& solver : scipy_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::runtime_error(name);
}

/// The problem of scipy_direct.py, which writes down what it is asked for.
Problem valley(bool constrained, Log& log) {
  Problem problem;
  problem.name = "valley";
  problem.source = "the solvers' tests";
  problem.lower = Vector{{-2, -1}};
  problem.upper = Vector{{2, 3}};
  problem.start = Vector{{-1.25, 1}};
  problem.constraints = constrained ? 2 : 0;
  problem.equalities = constrained ? 1 : 0;
  const auto values = [constrained](const Vector& x) {
    const double a = x[0] * x[0] - x[1];
    const double b = 1 - x[0];
    const double f = 100 * (a * a) + b * b;
    return constrained ? Values{f, Vector{{x[0] + x[1] - 1, a}}} : Values{f, {}};
  };
  problem.evaluate = [values, &log](const Vector& x) {
    log.push_back({"value", x});
    return values(x);
  };
  problem.differentiate = [values, constrained, &log](const Vector& x) {
    log.push_back({"gradient", x});
    const double a = x[0] * x[0] - x[1];
    const double b = 1 - x[0];
    Matrix jacobian(constrained ? 2 : 0, 2);
    if (constrained) jacobian << 1, 1, 2 * x[0], -1;
    return Derivatives{values(x), Vector{{400 * (a * x[0]) - 2 * b, -200 * a}}, jacobian};
  };
  return problem;
}

/// What SciPy asks for if it is called directly, and the point that it returns last.
Log asked_directly(const std::string& solver, bool constrained, std::uint32_t seed) {
  const std::string command =
      fmt::format("{} -I {}/tests/solvers/outside/scipy_direct.py {} {} {}", RICOCHET_PYTHON,
                  RICOCHET_SOURCE, solver, constrained ? "constrained" : "free", seed);
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  Log log;
  char line[1000];
  while (std::fgets(line, sizeof line, output.get()) != nullptr) {
    std::istringstream words(line);
    std::string kind, first, second;
    words >> kind >> first >> second;
    const Vector x{{std::strtod(first.c_str(), nullptr), std::strtod(second.c_str(), nullptr)}};
    // Objective and constraints of one point, one after the other, are one evaluation.
    if (kind == "constraints") kind = "value";
    if (log.empty() || log.back() != Asked{kind, x}) log.push_back({kind, x});
  }
  return log;
}

class Scipy : public testing::TestWithParam<std::string> {
 protected:
  static bool takes_constraints() {
    return solver_of(GetParam()).capabilities.constraints == Capabilities::Constraints::all;
  }
};

TEST_P(Scipy, AsksForWhatItAsksIfItIsCalledDirectly) {
  for (const bool constrained : {false, true}) {
    if (constrained && !takes_constraints()) continue;
    Log log;
    const Problem problem = valley(constrained, log);
    Evaluator evaluator(problem, {100'000});
    Random random(7);
    const SolverTermination end = solver_of(GetParam()).solve(evaluator, problem.start, random);
    Random same(7);
    Log direct = asked_directly(GetParam(), constrained, static_cast<std::uint32_t>(same() >> 32U));
    ASSERT_GT(direct.size(), 10U);
    const Vector returned = direct.back().x;
    direct.pop_back();
    // Those that draw are called directly for a few generations only.
    ASSERT_GE(log.size(), direct.size());
    const bool draws = solver_of(GetParam()).stochastic;
    if (!draws) {
      EXPECT_EQ(log.size(), direct.size());
      EXPECT_EQ(*end.point, returned);
    }
    for (std::size_t i = 0; i < direct.size(); ++i) ASSERT_EQ(log[i], direct[i]) << i;
  }
}

TEST_P(Scipy, GivesTheSameRunForTheSameSeedInEveryProcess) {
  const auto asked = [](std::uint64_t seed) {
    Log log;
    const Problem problem = valley(false, log);
    Evaluator evaluator(problem, {200});
    Random random(seed);
    solver_of(GetParam()).solve(evaluator, problem.start, random);
    return log;
  };
  const Log first = asked(1);
  EXPECT_EQ(asked(1), first);
  EXPECT_EQ(asked(2) == first, !solver_of(GetParam()).stochastic);
  const pid_t copy = fork();
  if (copy == 0) _exit(asked(1) == first ? 0 : 1);
  int status = 0;
  waitpid(copy, &status, 0);
  EXPECT_EQ(status, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, Scipy,
                         testing::Values("scipy-slsqp", "scipy-l-bfgs-b", "scipy-dual-annealing",
                                         "scipy-differential-evolution"),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(ScipySlsqp, AsksForAGradientAtAcceptedPointsOnly) {
  Log log;
  const Problem problem = valley(false, log);
  Evaluator evaluator(problem, {1000});
  Random random;
  solver_of("scipy-slsqp").solve(evaluator, problem.start, random);
  double accepted = 1e300;
  int gradients = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log[i].kind != "gradient") continue;
    ++gradients;
    ASSERT_EQ(log[i - 1].x, log[i].x) << "its value was asked for just before";
    Log ignored;
    const double value = valley(false, ignored).evaluate(log[i].x).objective;
    EXPECT_LE(value, accepted);
    accepted = value;
  }
  const auto values = static_cast<int>(log.size()) - gradients;
  EXPECT_LT(gradients, values * 0.9);
  // A gradient of a point whose value is known is charged n.
  EXPECT_EQ(evaluator.ledger().charged, values + 2 * gradients);
}

TEST(ScipySolvers, WorkOnCoordinatesWhoseBoxHasNoWidth) {
  for (const Solver& solver : scipy_solvers()) {
    Problem problem = sphere(3, 3);
    problem.lower[1] = problem.upper[1] = problem.start[1] = 5;
    Scorer scorer(problem);
    Evaluator evaluator(problem, {600}, &scorer);
    Random random;
    solver.solve(evaluator, problem.start, random);
    EXPECT_NEAR(scorer.best()->true_values.objective, 4, 0.1) << solver.name;
    EXPECT_EQ(scorer.best()->x[1], 5) << solver.name;
  }
}

/// The processes that this one has started, directly or not, and that run the program of SciPy.
std::vector<pid_t> programs(pid_t under = getpid()) {
  std::vector<pid_t> found;
  std::ifstream children(fmt::format("/proc/{}/task/{}/children", under, under));
  for (pid_t child = 0; children >> child;) {
    std::ifstream line(fmt::format("/proc/{}/cmdline", child));
    std::string words;
    std::getline(line, words);
    if (words.find("scipy_solvers.py") != std::string::npos) found.push_back(child);
    for (const pid_t further : programs(child)) found.push_back(further);
  }
  return found;
}

/// Waits until so many of them run; false after ten seconds.
bool come_to(std::size_t number) {
  for (int i = 0; i < 1000 && programs().size() != number; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return programs().size() == number;
}

TEST(ScipySolvers, ShareTheProgramOfTheProcessThatPreparedThem) {
  const Solver solver = solver_of("scipy-slsqp");
  solver.prepare();
  ASSERT_TRUE(come_to(1));
  const pid_t copy = fork();
  if (copy == 0) {
    const RunRecord record = run(sphere(2, 3), solver, {20}, 0);
    _exit(record.failure.empty() && record.ledger.charged > 0 && programs().empty() ? 0 : 1);
  }
  int status = 0;
  waitpid(copy, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(come_to(1)) << "what served the other process has ended";
}

TEST(ScipySolvers, LeaveNothingBehindThatIsStuck) {
  const Solver prepared = solver_of("scipy-slsqp");
  prepared.prepare();
  ASSERT_TRUE(come_to(1));
  const pid_t server = programs().front();
  {
    const Solver solver = solver_of("scipy-slsqp");
    run(sphere(2, 3), solver, {20}, 0);
    const std::vector<pid_t> both = programs();
    ASSERT_EQ(both.size(), 2U);
    ASSERT_EQ(kill(both.front() == server ? both.back() : both.front(), SIGSTOP), 0);
  }
  EXPECT_TRUE(come_to(1));
  EXPECT_EQ(programs(), std::vector<pid_t>{server});
}

TEST(ScipySolvers, StartTheProgramAgainIfItHasEnded) {
  const Solver solver = solver_of("scipy-l-bfgs-b");
  const RunRecord before = run(sphere(2, 3), solver, {20}, 0);
  EXPECT_EQ(before.failure, "");
  for (const pid_t program : programs()) kill(program, SIGKILL);
  ASSERT_TRUE(come_to(0));
  const RunRecord after = run(sphere(2, 3), solver, {20}, 0);
  EXPECT_EQ(after.failure, "");
  EXPECT_EQ(after.ledger.charged, before.ledger.charged);
}

}  // namespace
}  // namespace ricochet
