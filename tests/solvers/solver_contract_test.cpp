// What every solver promises, whatever is behind it.

#include <future>

#include "solvers/fireworks/fireworks.h"
#include "solvers/outside/line_solver.h"
#include "tests/solvers/solve.h"
#include "tests/support/golden.h"

namespace ricochet {
namespace {

/// One for each thing that a solver may want, or may not be able to do.
std::vector<Problem> touchstones() {
  std::vector<Problem> all;
  const auto add = [&](Problem problem, const std::string& name) -> Problem& {
    problem.name = name;
    return all.emplace_back(problem);
  };
  Problem& point = add(sphere(1, 3), "a-point");
  point.lower = point.upper = point.start;
  add(sphere(2, 3), "2-without-gradient").differentiate = nullptr;
  add(sphere(2, 3), "2-without-hessian").lagrangian_hessian = nullptr;
  add(sphere(2, 3), "2-without-residuals").residuals = nullptr;
  add(sphere(2, 3), "2-without-smoothing").smoothed = nullptr;
  add(limited(7), "limited");
  add(disc(), "disc");
  add(disc(), "disc-without-gradient").differentiate = nullptr;
  add(disc(), "disc-without-hessian").lagrangian_hessian = nullptr;
  add(disc(), "disc-without-smoothing").smoothed = nullptr;
  add(disc(), "disc-with-residuals").residuals = sphere(2, 3).residuals;
  add(arc(), "arc");
  add(arc(), "arc-without-gradient").differentiate = nullptr;
  Problem& of_1 = add(arc(), "arc-of-1");
  of_1.upper = of_1.start = Vector::Ones(1);
  of_1.lower = Vector::Zero(1);
  for (const Eigen::Index n : {1, 2, 8, 9, 10, 11}) add(sphere(n, 3), std::to_string(n));
  return all;
}

TEST(AllSolvers, AreThese) {
  std::map<std::string, Capabilities> all;
  for (const Solver& solver : all_solvers()) all[solver.name] = solver.capabilities;
  for (const MissingSolver& missing : missing_solvers()) {
    all[missing.solver] = missing.capabilities;
    EXPECT_THROW(solver_named(missing.solver), InputError);
  }
  std::map<std::string, std::string> names;  // of those that take the same
  for (const auto& [name, capabilities] : all) {
    std::string taken = fmt::format(
        "variables: {}; constraints: {}; needs: {}; accepts", capabilities.variables_in_words(),
        capabilities.constraints_in_words(), capabilities.needs_in_words());
    for (const Problem& problem : touchstones()) {
      if (capabilities.accept(problem)) taken += " " + problem.name;
    }
    names[taken] += "  " + name + "\n";
  }
  std::string text;
  for (const auto& [taken, by] : names) text += taken + "\n" + by;
  expect_golden(text, "solvers.txt");
}

TEST(AllSolvers, NameTheLibraryBehindThemAndItsVersion) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_THAT(solver.version,
                testing::MatchesRegex(
                    "(ricochet|NLopt|Ipopt|Ceres|pagmo|dlib|PETSc|SciPy) [0-9]+\\.[0-9]+\\.[0-9]+"
                    "( \\(adapter [0-9]+\\))?"))
        << solver.name;
  }
}

TEST(SolverNamed, IsTheOneOrAnErrorThatSaysWhatMayBeMeant) {
  EXPECT_EQ(solver_named("nlopt-sbplx").name, "nlopt-sbplx");
  EXPECT_THAT(
      complaint_of([] { return solver_named("nlopt-sbplex", "--solver"); }),
      AllOf(HasSubstr("--solver nlopt-sbplex: there is no such solver"), HasSubstr("nlopt-sbplx")));
}

TEST(AllSolvers, HaveBothReadingsOfTheThirdBranch) {
  const auto asked = [](const Solver& solver) {
    return asked_by_a_start(sphere(2, 3), solver, 500, 1);
  };
  const auto rounded = asked(fireworks::fireworks("", fireworks::paper_options()));
  const auto printed = asked(
      fireworks::fireworks("", {.counts = {.third_branch = fireworks::ThirdBranch::as_printed}}));
  EXPECT_NE(rounded, printed);
  EXPECT_EQ(asked(solver_named("fireworks")), rounded);
  EXPECT_EQ(asked(solver_named("fireworks-as-printed")), printed);
}

void expect_same_trace(const RunRecord& a, const RunRecord& b) {
  SCOPED_TRACE(a.problem);
  EXPECT_EQ(a.ledger.charged, b.ledger.charged);
  EXPECT_EQ(a.terminations, b.terminations);
  const auto improvements_of = [](const RunRecord& record) {
    std::vector<std::tuple<std::int64_t, double, double, Vector>> all;
    for (const auto& [evaluations, seconds, values, x] : record.trace) {
      all.emplace_back(evaluations, values.objective, values.violation, x);
    }
    return all;
  };
  EXPECT_EQ(improvements_of(a), improvements_of(b));
}

/// So often a solver may ask after it was refused: some finish a generation of about 100, and
/// Ceres's trust region tries some 170 shorter steps before it gives up.
constexpr std::int64_t most_refused = 500;

class SolverContract : public OfSolver {
 protected:
  /// The small problems it accepts; at least one.
  std::vector<Problem> accepted() const {
    std::vector<Problem> problems = {
        sphere(1, 3), sphere(2, 3),      sphere(5, -20),    staircase(),     disc(),    plateau(1),
        plateau(2),   never_a_number(1), never_a_number(2), half_a_number(), limited(7)};
    std::erase_if(problems, [&](const Problem& p) { return !solver().accepts(p); });
    EXPECT_FALSE(problems.empty());
    return problems;
  }

  /// Its own work for a point takes long.
  bool is_slow() const {
    const std::string& name = solver().name;
    return name.starts_with("dlib") || name.starts_with("scipy") || name == "tao-pounders" ||
           name.find("ipopt") != std::string::npos;
  }

  /// The smallest sphere it accepts, or the simplest of constraints.
  Problem easy() const {
    for (const Problem& problem : {sphere(1, 3), sphere(2, 3), limited(7)}) {
      if (solver().accepts(problem)) return problem;
    }
    return disc();
  }

  /// The same on the plane if it can, from a start with two coordinates.
  Problem easy_on_the_plane() const {
    Problem problem = sphere(2, 3);
    problem.start = Vector{{40, -7}};
    return solver().accepts(problem) ? problem : easy();
  }
};

TEST_P(SolverContract, SpendsItsBudgetAndNoMore) {
  for (const Problem& problem : accepted()) {
    for (const std::int64_t budget : {0, 1, 2, 3, 50, 200}) {
      SCOPED_TRACE(fmt::format("{} with {}", problem.name, budget));
      const RunRecord record = run(problem, solver(), {budget}, 0);
      EXPECT_LE(record.ledger.charged, budget);
      EXPECT_EQ(record.failure, "");
      EXPECT_LE(record.returned.has_value(), record.ledger.charged > 0);
      if (budget <= 2) {  // the evaluator refuses at once
        EXPECT_LE(record.ledger.refused, most_refused);
        EXPECT_THAT(record.terminations.back().reason,
                    testing::EndsWith("stopped by the evaluator"));
      }
      if (problem.name != "sphere") continue;
      const Eigen::Index n = problem.dimension();
      const Eigen::Index dearest = std::max(1 + n, n * (n + 1) / 2);  // call, in evaluations
      EXPECT_GT(record.ledger.charged, budget - dearest);
      EXPECT_EQ(record.termination_reason, TerminationReason::evaluations);
    }
  }
}

TEST_P(SolverContract, EndsWhenTheTimeIsSpent) {
  const RunRecord record = run(easy(), solver(), {1'000'000'000, 0.02}, 0);
  EXPECT_LE(record.ledger.refused, most_refused);
  EXPECT_EQ(record.termination_reason, TerminationReason::seconds);
  EXPECT_THAT(record.terminations.back().reason, testing::EndsWith("stopped by the evaluator"));
}

TEST_P(SolverContract, GivesTheSameTraceForTheSameRun) {
  for (const Problem& problem : accepted()) {
    const RunRecord first = run(problem, solver(), {150}, 1);
    for (const Vector& x : points_of(first)) EXPECT_TRUE(is_in_the_box(x, problem));
    run(problem, solver(), {40}, 2);  // leaves nothing behind in the library
    expect_same_trace(first, run(problem, solver(), {150}, 1));
  }
}

TEST_P(SolverContract, GivesTheSameTracesInTwoThreads) {
  const auto work = [this](int number) {
    std::vector<RunRecord> records;
    for (int repeat = 0; repeat < 3; ++repeat) {
      for (const Problem& problem : {easy(), disc()}) {
        if (!solver().accepts(problem)) continue;
        records.push_back(run(problem, solver(), {150}, number + repeat));
      }
    }
    return records;
  };
  auto one = std::async(std::launch::async, work, 1);
  auto two = std::async(std::launch::async, work, 2);
  const std::vector<RunRecord> parallel[] = {one.get(), two.get()};
  for (const int number : {1, 2}) {
    const std::vector<RunRecord> serial = work(number);
    const std::vector<RunRecord>& other = parallel[number - 1];
    ASSERT_EQ(serial.size(), other.size());
    for (std::size_t k = 0; k < serial.size(); ++k) expect_same_trace(serial[k], other[k]);
  }
}

// What sums several numbers at once may sum those before an aligned address one by one.
TEST_P(SolverContract, AsksTheSameWhereverItsMemoryLies) {
  const Problem problem = with_idle_knob(suite_problem("least-squares-30-chebyquad-7x7"));
  if (!solver().accepts(problem)) GTEST_SKIP() << "it takes no such problem";
  // Models grow with what was asked.
  const std::int64_t budget = solver().name == "dlib-global-search" ? 100 : 800;
  const std::vector<Vector> first = asked_by_a_start(problem, solver(), budget, 1);
  Random random(1);
  for (int repeat = 0; repeat < 8; ++repeat) {
    std::vector<std::vector<char>> occupied(5000);
    for (std::vector<char>& block : occupied) block.resize(random() % 2000);
    for (std::vector<char>& block : occupied) {
      if (random() % 2 == 0) std::vector<char>().swap(block);
    }
    EXPECT_TRUE(asked_by_a_start(problem, solver(), budget, 1) == first) << "repeat " << repeat;
  }
}

TEST_P(SolverContract, DrawsFromItsRandomStateIfItSaysSoAndOnlyThen) {
  const Problem problem = easy();
  const auto asked = [&](int seed) { return asked_by_a_start(problem, solver(), 100, seed); };
  const std::vector<Vector> first = asked(1);
  bool differs = false;  // a toss of a coin may come out alike for two seeds
  for (int seed = 2; seed < 12; ++seed) differs = differs || asked(seed) != first;
  EXPECT_EQ(differs, solver().stochastic);
  EXPECT_EQ(asked(1), first);
}

TEST_P(SolverContract, BeginsAtTheStart) {
  const Problem problem = easy_on_the_plane();
  const Vector first = asked_by_a_start(problem, solver(), 3, 1).front();
  // They begin with the ends or the middle of the box, or anywhere.
  const std::set<std::string> others = {"scan",           "bisection", "nlopt-direct",
                                        "nlopt-direct-l", "nlopt-ags", "talker"};
  EXPECT_EQ((first - problem.start).norm() < 1e-12, !others.contains(solver().name));
}

TEST_P(SolverContract, EndsAndReportsWhenTheProblemThrows) {
  for (const int calls : {0, 1, 7}) {
    const Problem problem = breaks_after(calls, easy().dimension());
    const RunRecord record = run(problem, solver(), {10000}, 0);
    EXPECT_EQ(record.failure, "broken scene");
    EXPECT_EQ(record.termination_reason, TerminationReason::failure);
    const Ledger& ledger = record.ledger;
    EXPECT_EQ(ledger.values + ledger.derivatives + ledger.hessians, calls);
    EXPECT_THAT(record.terminations.back().reason, testing::EndsWith("stopped by the evaluator"));
  }
}

TEST_P(SolverContract, SaysNothingEvenWhereItFails) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const Problem& problem : accepted()) run(problem, solver(), {100}, 0);
  run(breaks_after(4, easy().dimension()), solver(), {100}, 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(SolverContract, StaysInBoxesOfAnyPlaceAndWidth) {
  Random random(1);
  for (int trial = 0; trial < (is_slow() ? 4 : 20); ++trial) {
    Problem problem = easy_on_the_plane();
    const Eigen::Index n = problem.dimension();
    const double scale = std::pow(10, 6 * uniform(random) - 3);
    problem.lower = scale * normal(n, random);
    problem.upper = problem.lower + scale * normal(n, random).cwiseAbs();
    problem.start = (problem.lower + problem.upper) / 2;
    for (const Vector& x : asked_points(problem, solver(), is_slow() ? 60 : 700)) {
      ASSERT_TRUE(is_in_the_box(x, problem)) << x.transpose();
    }
  }
}

TEST_P(SolverContract, SearchesABoxWithoutWidthInACoordinate) {
  const Problem problem = with_fixed_coordinate(sphere(3, 3), 5);
  if (!solver().accepts(problem)) GTEST_SKIP() << "it takes no such problem";
  const std::int64_t budget = is_slow() ? 300 : 3000;
  for (const Vector& x : asked_points(problem, solver(), budget)) ASSERT_EQ(x[1], 5);
  EXPECT_LT(end_of(problem, solver(), budget), 4 + 55);
}

TEST_P(SolverContract, GetsPastValuesThatAreNotNumbers) {
  Problem problem = half_a_number();
  if (!solver().accepts(problem)) GTEST_SKIP() << "it takes no such problem";
  int numbers = 0;
  problem.evaluate = [&, evaluate = problem.evaluate](const Vector& x) {
    const Values values = evaluate(x);
    numbers += std::isfinite(values.objective);
    return values;
  };
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * (x.array() - 3); });
  run(problem, solver(), {200}, 0);
  EXPECT_GT(numbers, 10);
}

/// Those of the benchmark and two from outside, which are loaded when they are first asked.
std::vector<Solver> solvers_from_everywhere() {
  std::vector<Solver> solvers = all_solvers();
  const auto add = [&](const char* name, Solver (*make)(const std::string&), const char* file) {
    const std::shared_future<Solver> made = std::async(std::launch::deferred, make, file).share();
    Solver& solver = solvers.emplace_back();
    solver.name = name;
    solver.stochastic = true;
    solver.solve = [made](Evaluator& evaluator, const Vector& start, Random& random) {
      return made.get().solve(evaluator, start, random);
    };
  };
  add("plugin", outside::plugin, RICOCHET_FOLDER "/mine.so");
  add("talker", outside::line_solver, RICOCHET_FOLDER "/talker");
  return solvers;
}

INSTANTIATE_TEST_SUITE_P(Of, SolverContract, testing::ValuesIn(solvers_from_everywhere()),
                         by_solver);

}  // namespace
}  // namespace ricochet
