#include "solvers/outside/plugin.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <future>
#include <limits>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/child_process.h"
#include "tests/solvers/outside/scripts.h"
#include "tests/support/problems.h"

namespace ricochet::outside {
namespace {

using testing::HasSubstr;

std::string library(const std::string& name) {
  return RICOCHET_FOLDER "/" + name + ".so";
}

std::vector<Vector> points_of(const RunRecord& record) {
  std::vector<Vector> points;
  for (const Improvement& step : record.trace) points.push_back(step.x);
  return points;
}

TEST(Plugin, IsWhatItSaysItIs) {
  const Solver mine = plugin(library("mine"));
  EXPECT_EQ(mine.name, "mine");
  EXPECT_EQ(mine.version, "1.0");
  EXPECT_TRUE(mine.stochastic);
  EXPECT_TRUE(mine.accepts(sphere(2, 3)));
  EXPECT_FALSE(mine.accepts(disc()));
  const Solver newton = plugin(library("takes_constraints"));
  EXPECT_TRUE(newton.accepts(disc()));
  EXPECT_FALSE(newton.accepts(arc())) << "it has an equality";
  EXPECT_FALSE(newton.accepts(limited(7))) << "it has no derivatives";
  EXPECT_EQ(plugin(library("keeps_its_start")).name, "keeps_its_start");
}

TEST(Plugin, SolvesAndSpendsItsBudgetAndNoMore) {
  const Solver mine = plugin(library("mine"));
  const RunRecord record = run(sphere(2, 3), mine, {5000}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.ledger.charged, 5000);
  EXPECT_EQ(record.terminations.front().reason, "steps too short");
  EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
  EXPECT_LT(record.trace.back().true_values.objective, 1e-6);
  EXPECT_EQ(record.returned->x, record.trace.back().x);
  for (const std::int64_t budget : {0, 1, 2, 50}) {
    EXPECT_EQ(run(sphere(2, 3), mine, {budget}, 0).ledger.charged, budget);
  }
}

TEST(Plugin, MakesTheSameRunAgainInEveryThread) {
  const Solver mine = plugin(library("mine"));
  const auto work = [&](int number) {
    std::vector<std::vector<Vector>> all;
    for (int k = 0; k < 5; ++k) {
      for (const Problem& problem : {sphere(3, 3), staircase(), plateau(2), never_a_number(1)}) {
        all.push_back(points_of(run(problem, mine, {200}, number + k)));
      }
    }
    return all;
  };
  auto one = std::async(std::launch::async, work, 1);
  auto two = std::async(std::launch::async, work, 2);
  EXPECT_EQ(one.get(), work(1));
  EXPECT_EQ(two.get(), work(2));
  EXPECT_NE(work(1), work(2));
}

TEST(Plugin, SeesConstraintsAndTheirDerivatives) {
  const RunRecord record = run(disc(), plugin(library("takes_constraints")), {300}, 1);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.terminations.front().reason, "fifty steps");
  EXPECT_NEAR(record.terminations.front().point->norm(), 1, 1e-6);
  EXPECT_NE(record.terminations.front().point, record.terminations.at(1).point)
      << "it has another start";
}

TEST(Plugin, HandsOverTheBestShownWhereItSaysNothing) {
  Problem problem = sphere(2, 3);
  problem.upper.setConstant(5);
  problem.start.setConstant(-20);
  const RunRecord record = run(problem, plugin(library("keeps_its_start")), {2}, 0);
  EXPECT_EQ(record.returned->x, (Vector{{5, 5}}));
  EXPECT_EQ(record.terminations.front().reason, "done");
}

TEST(Plugin, GainsNothingByWritingIntoItsBox) {
  const Problem problem = sphere(2, 130);  // its best point is outside the box
  const RunRecord record = run(problem, plugin(library("widens_its_box")), {5}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.ledger.charged, 5);
  ASSERT_EQ(record.trace.size(), 1U);
  EXPECT_EQ(record.trace.front().x, Vector::Constant(2, 100));
  EXPECT_EQ(record.returned->x, Vector::Constant(2, 100));
  EXPECT_EQ(problem.lower, Vector::Constant(2, -100));
  EXPECT_EQ(problem.upper, Vector::Constant(2, 100));
  EXPECT_EQ(problem.start, Vector::Constant(2, 40));
}

TEST(Plugin, FailsWhereItThrows) {
  const RunRecord record = run(arc(), plugin(library("throws")), {20}, 0);
  EXPECT_EQ(record.failure, library("throws") + ": lost its way");
  EXPECT_EQ(record.ledger.charged, 1);
}

TEST(Plugin, IsStoppedWhereTheProblemThrows) {
  const RunRecord record = run(breaks_after(7, 2), plugin(library("mine")), {100}, 0);
  EXPECT_EQ(record.failure, "broken scene");
  EXPECT_EQ(record.ledger.values, 7);
}

TEST(Plugin, IsRefusedWhereItIsNone) {
  const auto refused = [](const std::string& path, const std::string& reason) {
    try {
      plugin(path);
      ADD_FAILURE() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path + ": "));
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  };
  refused("./nothing.so", "No such file");
  const auto text = fresh_folder() / "text.so";
  std::ofstream(text) << "I am no library.\n";
  refused(text.string(), "file too short");
  std::ofstream(text) << std::string(10000, 'x');
  refused(text.string(), "invalid ELF header");
  refused(library("without_a_solver"), "exports no ricochet_plugin");
  refused(library("of_another_interface"), "is made for interface 4, this is 3; compile it again");
  refused(library("without_solve"), "solve is NULL");
}

/// The bits of all objectives of a run.
std::string objectives_of(const RunRecord& record) {
  std::string bits = record.failure;
  for (const Improvement& step : record.trace) {
    bits += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(step.true_values.objective));
  }
  return bits;
}

/// Its own evaluations, and what another solver does after it in the same process, have the same
/// bits whatever it does to the floating-point environment, and whenever.
TEST(Plugin, LeavesTheFloatingPointEnvironmentAsItWas) {
  Problem sums = sphere(3, 0);
  sums.evaluate = [](const Vector& x) {
    volatile double sum = 0;
    for (int k = 1; k < 100; ++k) sum = sum + std::exp(-x[0] * k) / k;
    volatile double tiny = std::numeric_limits<double>::min();
    return Values{sum + x.norm() + (tiny / 3 > 0 ? 1 : 0), {}};
  };
  sums.differentiate = nullptr;
  const auto made = [&] {  // in another process, where it is loaded again
    return called_in_isolation(
        [&] {
          const Solver changes = plugin(library("changes_floating_point"));
          const std::string its_own = objectives_of(run(sums, changes, {60}, 0));
          return its_own + " then " +
                 objectives_of(run(sums, solver_named("nlopt-bobyqa"), {60}, 0)) +
                 fmt::format(" {} {}", std::fegetround(), fegetexcept());
        },
        std::chrono::seconds(20), 2000);
  };
  const std::string undisturbed = made();
  ASSERT_GT(undisturbed.size(), 200U);
  for (const char* when : {"loading", "solving", "between evaluations"}) {
    for (const char* change : {"up", "down", "to zero", "flush", "trap"}) {
      setenv("WHEN", when, 1);
      setenv("CHANGE", change, 1);
      EXPECT_TRUE(made() == undisturbed) << change << " when " << when;
    }
  }
}

TEST(Plugin, IsAnsweredInItsOwnThreadOnly) {
  const RunRecord record = run(sphere(2, 3), plugin(library("asks_from_threads")), {60}, 0);
  EXPECT_EQ(record.failure,
            library("asks_from_threads") + ": asked its problem from a second thread");
  EXPECT_EQ(record.ledger.charged, 1);
}

std::string refusal_of(const std::string& path) {
  try {
    plugin(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(Plugin, IsRefusedWhereLoadingItCrashes) {
  const std::string tried = ": cannot be loaded: the process that tried it crashed: ";
  EXPECT_EQ(refusal_of(library("aborts_on_load")), library("aborts_on_load") + tried + "Aborted");
  EXPECT_THAT(refusal_of(library("bad_name")), HasSubstr("cannot be loaded: the process that"));
}

TEST(Plugin, IsRefusedWhereItsFileIsCutOff) {
  const auto cut = fresh_folder() / "cut.so";
  const std::string whole = read(library("keeps_its_start"));
  for (const double share : {0.02, 0.1, 0.3}) {  // with debug information the rest is not loaded
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    std::ofstream(cut, std::ios::binary) << whole.substr(0, size);
    EXPECT_THAT(refusal_of(cut.string()), HasSubstr(cut.string())) << share;
  }
}

TEST(Plugin, IsRefusedWhereLoadingItNeverEnds) {
  EXPECT_EQ(refusal_of(library("hangs_on_load")),
            library("hangs_on_load") +
                ": cannot be loaded: the process that tried it took more than 10 s");
}

}  // namespace
}  // namespace ricochet::outside
