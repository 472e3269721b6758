#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "src/core/instance.h"
#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/studies/stress/stress.h"

namespace ricochet::studies {
namespace {

using testing::StartsWith;

Solver named(const char* name) {
  Solver solver;
  solver.name = name;
  return solver;
}

/// Looks at the best point, where there is one, and then at others until it is stopped.
Solver lucky() {
  Solver solver = named("lucky");
  solver.solve = [](Evaluator& evaluator, const Vector& start,
                    Random& random) -> SolverTermination {
    Vector x = start;
    for (const stress::PathologicalProblem& ill : stress::pathological_problems()) {
      if (ill.problem.name == evaluator.name()) x = ill.problem.best_point.value_or(start);
    }
    while (evaluator.objective(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return {"stopped"};
  };
  return solver;
}

Solver crashing() {
  Solver solver = named("crashing");
  solver.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    kill(getpid(), SIGKILL);
    return {};
  };
  return solver;
}

Solver lazy() {
  Solver solver = named("lazy");
  solver.solve = [](Evaluator&, const Vector&, Random&) { return SolverTermination{"no"}; };
  return solver;
}

/// How that solver's run on that problem ended; null where it was not put to it.
report::Json ending(const report::Json& data, std::size_t solver, const std::string& problem) {
  for (std::size_t k = 0; k < data["problems"].size(); ++k) {
    if (data["problems"][k]["problem"] == problem) return data["solvers"][solver]["endings"][k];
  }
  ADD_FAILURE() << "no problem " << problem;
  return {};
}

TEST(StressStudy, KeepsARecordOfEveryRunWhateverHappens) {
  const auto data = stress_study({lucky(), crashing(), lazy()}).compute(false);
  const std::size_t problems = data["problems"].size();
  const std::size_t taken = problems - 2;
  EXPECT_EQ(data["counts"]["runs"], 3 * taken) << "none takes constraints or a box of one point";
  EXPECT_EQ(data["counts"]["crashed"], taken);
  int counted = 0;
  for (const char* kind : {"solved", "spent", "ended", "threw", "killed", "crashed"}) {
    counted += data["counts"][kind].get<int>();
  }
  EXPECT_EQ(counted, data["counts"]["runs"]);
  EXPECT_EQ(ending(data, 0, "no-number")["ending"], "solved at 1");
  EXPECT_EQ(ending(data, 0, "cliff")["kind"], "solved");
  EXPECT_EQ(ending(data, 0, "throws")["kind"], "threw");
  EXPECT_EQ(ending(data, 0, "throws")["reasons"], "the model broke");
  EXPECT_EQ(ending(data, 0, "plateau")["ending"], "spent 400");
  EXPECT_EQ(ending(data, 0, "sleeps")["kind"], "killed");
  EXPECT_EQ(ending(data, 0, "sleeps")["improvements"], 1);
  EXPECT_EQ(ending(data, 0, "budget-1")["kind"], "solved");
  EXPECT_EQ(ending(data, 0, "budget-0")["ending"], "spent 0");
  EXPECT_TRUE(ending(data, 0, "infeasible")["ending"].is_null());
  EXPECT_TRUE(ending(data, 0, "one-point")["ending"].is_null());
  EXPECT_THAT(ending(data, 1, "cliff")["ending"], StartsWith("crashed"));
  EXPECT_EQ(ending(data, 2, "cliff")["ending"], "ended at 0");
}

TEST(StressStudy, FillsItsPage) {
  auto data = stress_study({lucky(), lazy()}).compute(false);
  data["made"] = {{"version", "1"}, {"compiler", "c"}, {"threads", 2}, {"seconds", 1.5}};
  const report::DrawnPage drawn = report::drawn(report::page_template("stress"), data);
  const report::Table& table = drawn.page.sections.at(0).tables.at(0);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.columns.size(), 1 + data["problems"].size());
  EXPECT_EQ(table.rows[0][1].text, "solved at 1");
}

TEST(PathologicalProblems, AreAsTheySay) {
  for (const auto& [what, problem, budget, limits] : stress::pathological_problems()) {
    EXPECT_TRUE((problem.start.array() >= problem.lower.array()).all()) << problem.name;
    if (problem.name == "sleeps") continue;
    if (!problem.best_known || problem.name == "throws") continue;
    EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, *problem.best_known)
        << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::studies
