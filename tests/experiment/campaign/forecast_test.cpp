#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/evaluator.h"
#include "src/experiment/planned_runs.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet {
namespace {

/// Processor time [s] that is burnt.
void burn(double seconds) {
  Stopwatch stopwatch;
  while (stopwatch.read() < seconds) {
  }
}

Forecast foretold(double simulation, double solver, const std::string& rest) {
  Catalogue catalogue = made_up_catalogue();
  Problem& problem = catalogue.families[0].problems[0];
  problem.evaluate = [evaluate = problem.evaluate, simulation](const Vector& x) {
    burn(simulation);
    return evaluate(x);
  };
  catalogue.solvers[0].solve = [solver](Evaluator& evaluator, const Vector& start, Random&) {
    while (evaluator.objective(start)) burn(solver);
    return SolverTermination{"spent"};
  };
  return forecast_of(Campaign(
      plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"chance-a\"\n" + rest, "test"),
      catalogue));
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
  const auto least = [](const std::string& perturbation) {
    double seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Forecast forecast = foretold(
          5e-4, 0, "budgets = 100\ninstances = 10\nperturbations = \"" + perturbation + "\"");
      seconds = std::min(seconds, forecast.runs);
    }
    return seconds;
  };
  const double plain = least("plain");
  const double noisy = least("noisy");
  EXPECT_GT(noisy, 1.6 * plain);
  EXPECT_LT(noisy, 2.4 * plain);
}

TEST(Forecast, HasTheStartOfASolverOnceForEveryProcess) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.solvers[0].solve = [solve = catalogue.solvers[0].solve,
                                started = std::make_shared<bool>(false)](
                                   Evaluator& evaluator, const Vector& start, Random& random) {
    if (!std::exchange(*started, true)) burn(0.05);
    return solve(evaluator, start, random);
  };
  const Forecast forecast = forecast_of(
      Campaign(plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"chance-a\"\nbudgets = 2\n"
                         "instances = 100",
                         "test"),
               catalogue));
  EXPECT_GT(forecast.runs, 0.05);
  EXPECT_LT(forecast.runs, 100 * 0.05 / 2) << "not for every run, though on a busy machine";
}

TEST(Forecast, HasTheSearchForBestValues) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [](const MachineGrid&) {
    Problem slow = bowl("bowl-slow", 1);
    slow.scan_step = 1e-3;
    slow.evaluate = [evaluate = slow.evaluate](const Vector& x) {
      burn(5e-4);
      return evaluate(x);
    };
    return std::vector{searched(slow, nullptr)};
  };
  const Forecast forecast =
      forecast_of(Campaign(plan_from("[[part]]\nmachines = { around = \"C1\" }\nproblems = \"*\"\n"
                                     "solvers = \"chance-a\"\nbudgets = 2\ninstances = 1",
                                     "test"),
                           catalogue));
  EXPECT_GE(forecast.search, 0.49) << "1000 steps of at least 0.5 ms";
  EXPECT_LT(forecast.search, 5) << "a busy machine takes longer, but not so much";
}

TEST(Forecast, IsALowerLimitWhereASolverCannotBeTimed) {
  Catalogue catalogue = made_up_catalogue();
  const auto plan = plan_from(
      "[[part]]\nproblems = \"bowl-1\"\nsolvers = [\"chance-a\", \"chance-b\"]\nbudgets = 2",
      "test");
  EXPECT_FALSE(forecast_of(Campaign(plan, catalogue)).at_least);
  catalogue.solvers[1].solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::runtime_error("not started");
  };
  EXPECT_TRUE(forecast_of(Campaign(plan, catalogue)).at_least);
}

TEST(Forecast, SharesAllButThePagesAmongCores) {
  const Forecast forecast{4, 10, 2.25};
  EXPECT_NEAR(forecast.seconds(1), 16.25, 0.1);
  EXPECT_NEAR(forecast.seconds(4), 4.25, 0.25);
}

TEST(Forecast, ShowsItsProgressOnATerminal) {
  int ours = -1;
  int terminal = -1;
  ASSERT_EQ(openpty(&ours, &terminal, nullptr, nullptr, nullptr), 0);
  const int standard_error = dup(STDERR_FILENO);
  dup2(terminal, STDERR_FILENO);
  foretold(0, 0, "budgets = 2");
  dup2(standard_error, STDERR_FILENO);
  std::string shown(1000, '\0');
  shown.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ours, shown.data(), 1000))));
  EXPECT_NE(shown.find("timing problems"), std::string::npos) << shown;
  for (const int each : {ours, terminal, standard_error}) close(each);
}

TEST(Forecast, OutlivesAProblemThatThrows) {
  Catalogue catalogue = made_up_catalogue();
  Problem& problem = catalogue.families[0].problems[0];
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("ill"); };
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"chance-a\"\nbudgets = 5", "test"),
      catalogue);
  EXPECT_GT(forecast_of(campaign).runs, 0);
}

/// It does not evaluate the problem in this process, and expects that its runs hang.
TEST(Forecast, OutlivesAProblemThatHangs) {
  Catalogue catalogue = made_up_catalogue();
  Problem& problem = catalogue.families[0].problems[0];
  problem.hazardous = true;
  problem.longest_run = 2;
  problem.evaluate = [](const Vector&) -> Values { std::abort(); };
  problem.true_values = [](const Vector&) { return TrueValues{}; };
  const Campaign campaign(
      plan_from("[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = \"chance-a\"\n"
                "budgets = 5\ninstances = 3",
                "test"),
      catalogue);
  const Forecast forecast = forecast_of(campaign);
  EXPECT_GT(forecast.runs, 6);
  EXPECT_LT(forecast.runs, 7);
  EXPECT_FALSE(forecast.at_least);
}

}  // namespace
}  // namespace ricochet
