#include <csignal>

#include "solvers/library_solvers.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

/// What a solver asked for, "value" or "gradient", and where.
using Log = std::vector<std::pair<std::string, Vector>>;

/// The problem of scipy_direct.py, which writes down what it is asked for.
Problem valley(bool constrained, Log& log) {
  Problem problem = box_problem("valley", 2, 0, 0, 0, [](const Vector&) { return 0.0; });
  problem.lower = Vector{{-2, -1}};
  problem.upper = Vector{{2, 3}};
  problem.start = Vector{{-1.25, 1}};
  problem.constraints = constrained ? 2 : 0;
  problem.equalities = constrained ? 1 : 0;
  const auto values = [constrained](const Vector& x) {
    const double a = x[0] * x[0] - x[1], b = 1 - x[0];
    const double f = 100 * (a * a) + b * b;
    return constrained ? Values{f, Vector{{x[0] + x[1] - 1, a}}} : Values{f, {}};
  };
  problem.evaluate = [values, &log](const Vector& x) {
    return log.emplace_back("value", x), values(x);
  };
  problem.differentiate = [values, constrained, &log](const Vector& x) {
    log.emplace_back("gradient", x);
    const double a = x[0] * x[0] - x[1], b = 1 - x[0];
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
    if (log.empty() || log.back() != std::pair(kind, x)) log.emplace_back(kind, x);
  }
  return log;
}

class Scipy : public OfSolver {
 protected:
  /// What it asks for from the problem's start.
  Log asked(std::uint64_t seed, bool constrained = false, std::int64_t evaluations = 200) {
    Log log;
    end_ = solved(valley(constrained, log), solver(), evaluations, seed);
    return log;
  }

  Solved end_;
};

TEST_P(Scipy, AsksForWhatItAsksIfItIsCalledDirectly) {
  for (const bool constrained : {false, true}) {
    Log ignored;
    if (!solver().accepts(valley(constrained, ignored))) continue;
    const Log log = asked(7, constrained, 100'000);
    Random same(7);
    Log direct =
        asked_directly(solver().name, constrained, static_cast<std::uint32_t>(same() >> 32U));
    ASSERT_GT(direct.size(), 10U);
    const Vector returned = direct.back().second;
    direct.pop_back();
    // Those that draw are called directly for a few generations only.
    ASSERT_GE(log.size(), direct.size());
    if (!solver().stochastic) {
      EXPECT_EQ(log.size(), direct.size());
      EXPECT_EQ(*end_.point, returned);
    }
    for (std::size_t i = 0; i < direct.size(); ++i) ASSERT_EQ(log[i], direct[i]) << i;
  }
}

TEST_P(Scipy, GivesTheSameRunForTheSameSeedInEveryProcess) {
  const Log first = asked(1);
  EXPECT_TRUE(holds_in_a_copy([&] { return asked(1) == first; }));
}

INSTANTIATE_TEST_SUITE_P(Of, Scipy, testing::ValuesIn(scipy_solvers()), by_solver);

TEST(ScipySolvers, WorkOnCoordinatesWhoseBoxHasNoWidth) {
  for (const Solver& solver : scipy_solvers()) {
    const Improvement best = *solved(with_fixed_coordinate(sphere(3, 3), 5), solver, 600).best;
    EXPECT_NEAR(best.true_values.objective, 4, 0.1) << solver.name;
    EXPECT_EQ(best.x[1], 5) << solver.name;
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
  const Solver solver = solver_named("scipy-slsqp");
  solver.prepare();
  ASSERT_TRUE(come_to(1));
  EXPECT_TRUE(holds_in_a_copy([&] {
    const RunRecord record = run(sphere(2, 3), solver, {20}, 0);
    return record.failure.empty() && record.ledger.charged > 0 && programs().empty();
  }));
  EXPECT_TRUE(come_to(1)) << "what served the other process has ended";
}

TEST(ScipySolvers, LeaveNothingBehindThatIsStuck) {
  const Solver prepared = solver_named("scipy-slsqp");
  prepared.prepare();
  ASSERT_TRUE(come_to(1));
  const pid_t server = programs().front();
  {
    const Solver solver = solver_named("scipy-slsqp");
    run(sphere(2, 3), solver, {20}, 0);
    const std::vector<pid_t> both = programs();
    ASSERT_EQ(both.size(), 2U);
    ASSERT_EQ(kill(both.front() == server ? both.back() : both.front(), SIGSTOP), 0);
  }
  EXPECT_TRUE(come_to(1));
  EXPECT_EQ(programs(), std::vector<pid_t>{server});
}

TEST(ScipySolvers, StartTheProgramAgainIfItHasEnded) {
  const Solver solver = solver_named("scipy-l-bfgs-b");
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
