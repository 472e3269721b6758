#include "ricochet/evaluator.h"
#include "src/core/time_limit.h"
#include "src/experiment/planned_runs.h"
#include "tests/support/campaigns.h"
#include "tests/support/pipe.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

/// Processor time [s] that is burnt.
void burn(double seconds) {
  const double end = processor_seconds() + seconds;
  while (processor_seconds() < end) {
  }
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
  changed.problem.evaluate = [evaluate = changed.problem.evaluate, simulation](const Vector& x) {
    burn(simulation);
    return evaluate(x);
  };
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
      const Forecast forecast = foretold(
          5e-4, 0, "budgets = 100\ninstances = 10\nperturbations = \"" + perturbation + "\"");
      seconds = std::min(seconds, forecast.runs);
    }
    return seconds;
  };
  const double plain = least_of_three("plain");
  const double noisy = least_of_three("noisy");
  EXPECT_GT(noisy, 1.6 * plain);
  EXPECT_LT(noisy, 2.4 * plain);
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
  changed.catalogue.grid_problems = [](const MachineGrid&) {
    Problem slow = bowl("bowl-slow", 1);
    slow.scan_step = 1e-3;
    slow.evaluate = [evaluate = slow.evaluate](const Vector& x) {
      burn(5e-4);
      return evaluate(x);
    };
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
              testing::HasSubstr("timing problems"));
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
