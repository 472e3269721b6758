#include "src/benchmark/experiment/campaign/forecast.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <thread>

#include "ricochet/stopwatch.h"
#include "tests/benchmark/experiment/campaign/made_up_catalogue.h"

namespace ricochet {
namespace {

/// Processor time [s] that is burnt.
void burn(double seconds) {
  Stopwatch stopwatch;
  while (stopwatch.read() < seconds) {
  }
}

double foretold(double simulation, double solver, const std::string& rest) {
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
  return foretold_seconds(Campaign(
      plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"chance-a\"\n" + rest, "test"),
      catalogue));
}

TEST(Forecast, IsTheTimeOfSimulationsAndOfTheSolver) {
  // Half a millisecond and a quarter for each of 10 runs of 20 and of 2000 evaluations.
  const double seconds = foretold(5e-4, 2.5e-4, "budgets = [20, 2000]\ninstances = 5\nseeds = 2");
  EXPECT_GT(seconds, 10 * 2020 * 7.0e-4);
  EXPECT_LT(seconds, 10 * 2020 * 1.2e-3);
}

TEST(Forecast, HasItsShareForEveryRun) {
  const double one = foretold(0, 0, "budgets = 2\ninstances = 1000");
  EXPECT_GT(one, 0.9);
  EXPECT_LT(one, 5);
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
  EXPECT_GT(foretold_seconds(campaign), 0);
}

}  // namespace
}  // namespace ricochet
