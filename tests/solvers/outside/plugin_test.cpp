#include "solvers/outside/plugin.h"

#include <cfenv>

#include "solvers/outside/outside.h"
#include "src/core/child_process.h"
#include "tests/solvers/solve.h"

namespace ricochet::outside {
namespace {

// Those that are accepted are those of line_solver_test.cpp.
TEST(AskedPoints, AreRefusedWithWhatIsWrong) {
  const nlohmann::ordered_json usual = {{"x", {1, 2}}};
  EXPECT_TRUE(asked_points(usual, "x", 2, {.derivatives = true}).wanted.derivatives);
  expect_refusals(
      [](const std::string& line) {
        return asked_points(nlohmann::ordered_json::parse(line), "x", 2);
      },
      {{R"({"x": [1]})", "x must have 2 numbers"},
       {R"({"x": 1})", "x must have 2 numbers"},
       {R"({"x": []})", "x must have 2 numbers"},
       {R"({"x": [1, [2]]})", "x must have 2 numbers: entry 2 is of type array"},
       {R"({"x": [[1, 2], [3]]})", "x must have 2 numbers in point 2"},
       {R"({"x": [[1, 2], ["3", 4]]})", "2 numbers in point 2: entry 1 is of type string"},
       {R"({"x": [1, 2], "residual": true})", "residual is not expected; did you mean residuals?"},
       {R"({"x": [1, 2], "residuals": 1})", "residuals must be true or false"}});
}

TEST(Claims, HoldANameThatCanStandInAList) {
  EXPECT_EQ(solver_as_claimed({"Mine_2.0+x-y", "1"}, "here").name, "Mine_2.0+x-y");
  EXPECT_EQ(solver_as_claimed({"mine", "1\x1b[31m\n"}, "here").version, "1\\x1b[31m\\x0a");
  for (const std::string& name :
       std::vector<std::string>{"", "a,b", "a b", "*", std::string(61, 'a')}) {
    EXPECT_THAT(complaint_of([&] {
                  return solver_as_claimed({name, "1"}, "here");
                }),
                StartsWith("here: name \"" + name + "\"; allowed"));
  }
}

std::string library(const std::string& name) {
  return RICOCHET_FOLDER "/" + name + ".so";
}

TEST(Outside, IsALibraryAProgramOrNothing) {
  EXPECT_EQ(outside_solver("fireworks"), std::nullopt);
  EXPECT_EQ(outside_solver("nothing.so"), std::nullopt);
  const fs::path spaced = fresh_folder() / "of mine" / "mine.so";
  fs::create_directory(spaced.parent_path());
  fs::copy_file(library("mine"), spaced);
  for (const std::string& mine : {library("mine"), spaced.string()}) {
    EXPECT_EQ(outside_solver(mine)->name, "mine") << mine;
  }
  for (const char* command : {RICOCHET_FOLDER "/talker", RICOCHET_FOLDER "/talker 7",
                              "sh -c 'exec " RICOCHET_FOLDER "/talker'",
                              "sh -c 'exec " RICOCHET_FOLDER "/talker' /some.so"}) {
    EXPECT_EQ(outside_solver(command)->name, "talker") << command;
  }
}

TEST(Outside, IsToldWhatIsWrong) {
  const fs::path file = write_file(fresh_folder() / "mine.py", "print()\n");
  fs::current_path(file.parent_path());
  expect_named_refusals(outside_solver,
                        {{"./nothing", "there is no such file"},
                         {"./nothing.so", "No such file"},
                         {file.string(), "For example \"python3 " + file.string() + "\""},
                         {"mine.py", "a file is given with its folder, ./mine.py"}});
}

TEST(Plugin, IsWhatItSaysItIs) {
  const Solver mine = plugin(library("mine"));
  EXPECT_EQ(mine.name, "mine");
  EXPECT_EQ(mine.version, "1.0");
  EXPECT_TRUE(mine.stochastic);
  EXPECT_EQ(mine.capabilities, Capabilities{});
  EXPECT_EQ(plugin(library("takes_constraints")).capabilities,
            (Capabilities{.constraints = Capabilities::Constraints::inequalities,
                          .derivatives = Capabilities::Order::gradient}));
  EXPECT_EQ(plugin(library("keeps_its_start")).name, "keeps_its_start");
}

TEST(Plugin, Solves) {
  const RunRecord record = run(sphere(2, 3), plugin(library("mine")), {5000}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.terminations.front().reason, "steps too short");
  EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
  EXPECT_LT(best_of(record).objective, 1e-6);
  EXPECT_EQ(record.returned->x, record.trace.back().x);
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
  const Vector corner = Vector::Constant(2, 100);
  EXPECT_THAT(points_of(record), ElementsAre(corner));
  EXPECT_EQ(record.returned->x, corner);
  EXPECT_THAT((std::vector{problem.lower, problem.upper, problem.start}),
              ElementsAre(-corner, corner, 0.4 * corner));
}

TEST(Plugin, FailsWhereItThrows) {
  const RunRecord record = run(arc(), plugin(library("throws")), {20}, 0);
  EXPECT_EQ(record.failure, library("throws") + ": lost its way");
  EXPECT_EQ(record.ledger.charged, 1);
}

TEST(Plugin, IsAnsweredInItsOwnThreadOnly) {
  const RunRecord record = run(sphere(2, 3), plugin(library("asks_from_threads")), {60}, 0);
  EXPECT_EQ(record.failure,
            library("asks_from_threads") + ": asked its problem from a second thread");
  EXPECT_EQ(record.ledger.charged, 1);
}

TEST(Plugin, IsRefusedWhereItIsNone) {
  const fs::path folder = fresh_folder();
  expect_named_refusals(
      plugin,
      {{"./nothing.so", "No such file"},
       {write_file(folder / "text.so", "I am no library.\n").string(), "file too short"},
       {write_file(folder / "long.so", std::string(10000, 'x')).string(), "invalid ELF header"},
       {library("without_a_solver"), "exports no ricochet_plugin"},
       {library("of_another_interface"), "is made for interface 4, this is 3; compile it again"},
       {library("without_solve"), "solve is NULL"}});
}

TEST(Plugin, IsRefusedWhereItsFileIsCutOff) {
  const std::string whole = text_of(fs::path(library("keeps_its_start")));
  for (const double share : {0.02, 0.1, 0.3}) {  // with debug information the rest is not loaded
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    const fs::path cut = write_file(fresh_folder() / "cut.so", whole.substr(0, size));
    EXPECT_THAT(complaint_of([&] { return plugin(cut.string()); }), HasSubstr(cut.string()))
        << share;
  }
}

const std::string tried = ": cannot be loaded: the process that tried it ";

TEST(Plugin, IsRefusedWhereLoadingItCrashes) {
  expect_refusals(
      plugin, {{library("aborts_on_load"), library("aborts_on_load") + tried + "crashed: Aborted"},
               {library("bad_name"), tried}});
}

TEST(Plugin, IsRefusedWhereLoadingItNeverEnds) {
  expect_refusals(plugin, {{library("hangs_on_load"),
                            library("hangs_on_load") + tried + "took more than 10 s"}});
}

/// Its own evaluations, and what another solver does after it in the same process, have the same
/// bits whatever it does to the floating-point environment, and whenever.
TEST(Plugin, LeavesTheFloatingPointEnvironmentAsItWas) {
  const Problem sums = box_problem("sums", 3, -100, 100, 40, [](const Vector& x) {
    volatile double sum = 0;
    for (int k = 1; k < 100; ++k) sum = sum + std::exp(-x[0] * k) / k;
    volatile double tiny = std::numeric_limits<double>::min();
    return sum + x.norm() + (tiny / 3 > 0 ? 1 : 0);
  });
  const auto made = [&] {  // in another process, where it is loaded again
    return called_in_isolation(
        [&] {
          std::string bits;
          for (const Solver& solver :
               {plugin(library("changes_floating_point")), solver_named("nlopt-bobyqa")}) {
            const RunRecord record = run(sums, solver, {60}, 0);
            bits += record.failure;
            for (const Improvement& step : record.trace) {
              bits += fmt::format(" {:a}", step.true_values.objective);
            }
          }
          return bits + fmt::format(" {} {}", std::fegetround(), fegetexcept());
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

}  // namespace
}  // namespace ricochet::outside
