#include "solvers/outside/line_solver.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "tests/solvers/outside/scripts.h"
#include "tests/support/problems.h"

namespace ricochet::outside {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string talker = RICOCHET_FOLDER "/talker";

/// A script greets, and then does what these lines say; `say` writes a line, `hear` reads one.
std::string speaker(const std::string& lines, const std::string& greeting = R"({"name": "mine"})") {
  return script(fresh_folder(), "say() { echo \"$1\"; }\nhear() { read -r heard; }\nsay '" +
                                    greeting + "'\n" + lines);
}

std::filesystem::path folder_of(const std::string& command) {
  return std::filesystem::path(command.substr(command.find(' ') + 1)).parent_path();
}

std::vector<std::string> reasons_of(const RunRecord& record) {
  std::vector<std::string> reasons;
  for (const SolverTermination& exit : record.terminations) reasons.push_back(exit.reason);
  return reasons;
}

std::vector<Vector> points_of(const RunRecord& record) {
  std::vector<Vector> points;
  for (const Improvement& step : record.trace) points.push_back(step.x);
  return points;
}

/// What a run of a script on the plane is said to have failed with, after its command.
std::string failure_of(const std::string& lines) {
  const std::string command = speaker(lines);
  const std::string failure = run(sphere(2, 3), line_solver(command), {20}, 0).failure;
  EXPECT_THAT(failure, StartsWith(command + ": "));
  return failure.substr(std::min(failure.size(), command.size() + 2));
}

TEST(LineSolver, IsWhatTheProgramSaysItIs) {
  const Solver plain = line_solver(speaker("hear", R"({"name": "a"})"));
  EXPECT_EQ(plain.name, "a");
  EXPECT_FALSE(plain.stochastic);
  EXPECT_FALSE(plain.accepts(disc()));
  const Solver rich = line_solver(speaker(
      "hear",
      R"({"name": "b", "version": "7", "takes_constraints": 2, "needs_derivatives": true, "stochastic": true})"));
  EXPECT_EQ(rich.name, "b");
  EXPECT_EQ(rich.version, "7");
  EXPECT_TRUE(rich.stochastic);
  EXPECT_TRUE(rich.accepts(arc()));
  EXPECT_FALSE(rich.accepts(limited(7))) << "it has no derivatives";
}

TEST(LineSolver, SpeaksAsTheReadmeSays) {
  const std::string command = speaker(R"(
hear; say "$heard" > $HERE/heard
for line in '{"ask": [1, 2]}' '{"ask": [1, 2], "derivatives": true}' '{"ask": [[0, 0], [3, 3]]}' \
            '{"ask": [-5, null]}' '{"ask": [0, 0]}'; do
  say "$line"; hear; say "$heard" >> $HERE/heard
done
say '{"done": "all asked", "point": [1, 2]}')",
                                      R"({"name": "mine", "takes_constraints": 2})");
  const RunRecord record = run(arc(), line_solver(command), {20}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.termination_reason, TerminationReason::bad_point);
  EXPECT_EQ(record.ledger.charged, 1 + 2 + 2) << "derivatives where the values are known cost 2";
  EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator"));
  EXPECT_EQ(record.returned->x, (Vector{{1, 2}}));
  const std::string heard = read(folder_of(command) / "heard");
  EXPECT_THAT(
      heard,
      testing::MatchesRegex(
          R"x(\{"ricochet":1,"name":"arc","dimension":2,"lower":\[-2.0,-2.0\],"upper":\[2.0,2.0\],"start":\[1.5,1.5\],"constraints":2,"equalities":1,"derivatives":true,"residuals":false,"budget":20,"seed":[0-9]+\}
\{"objective":3.0,"constraints":\[4.0,-1.5\],"remaining":19\}
\{"objective":3.0,"constraints":\[4.0,-1.5\],"gradient":\[1.0,1.0\],"jacobian":\[\[2.0,4.0\],\[-1.0,0.0\]\],"remaining":17\}
\{"objective":\[0.0,4.0\],"constraints":\[\[-1.0,-0.5\],\[7.0,-2.5\]\],"remaining":15\}
\{"stop":true\}
\{"stop":true\}
)x"));
}

TEST(LineSolver, AsksForResiduals) {
  const std::string command = speaker(R"(
hear
for line in '{"ask": [[1, 3], [4, 3]], "residuals": true}' \
            '{"ask": [4, 3], "residuals": true, "derivatives": true}'; do
  say "$line"; hear; say "$heard" >> $HERE/heard
done
say '{"done": "all asked"}')",
                                      R"({"name": "mine", "needs_residuals": true})");
  const Solver solver = line_solver(command);
  EXPECT_FALSE(solver.accepts(limited(7)));
  Problem problem = sphere(2, 3);
  EXPECT_TRUE(solver.accepts(problem));
  problem.residuals = [](const Vector& x) {
    return Residuals{x.array() - 3, 2 * Matrix::Identity(2, 2)};
  };
  Evaluator evaluator(problem, {4});
  Random random;
  solver.solve(evaluator, problem.start, random);
  EXPECT_EQ(read(folder_of(command) / "heard"),
            R"({"residuals":[[-2.0,0.0],[1.0,0.0]],"remaining":2}
{"residuals":[1.0,0.0],"residual_jacobian":[[2.0,0.0],[0.0,2.0]],"remaining":0}
)");
}

TEST(LineSolver, SpendsItsBudgetAndNoMore) {
  for (const std::string& command : {talker, talker + " 7"}) {
    const Solver solver = line_solver(command);
    for (const std::int64_t budget : {0, 1, 20, 1000}) {
      const RunRecord record = run(sphere(2, 3), solver, {budget}, 0);
      EXPECT_EQ(record.ledger.charged, budget);
      EXPECT_EQ(record.failure, "");
      EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator"));
    }
  }
}

TEST(LineSolver, MakesTheSameRunAgain) {
  const Solver solver = line_solver(talker);
  const RunRecord first = run(sphere(3, 3), solver, {200}, 1);
  run(sphere(2, 3), solver, {50}, 2);
  EXPECT_EQ(points_of(first), points_of(run(sphere(3, 3), solver, {200}, 1)));
  EXPECT_NE(points_of(first), points_of(run(sphere(3, 3), solver, {200}, 2)));
  EXPECT_EQ(points_of(first), points_of(run(sphere(3, 3), line_solver(talker + " 7"), {200}, 1)))
      << "all the same in batches";
  EXPECT_EQ(points_of(first),
            points_of(run(sphere(3, 3), line_solver("sh -c '" + talker + "'"), {200}, 1)));
}

TEST(LineSolver, MakesTheSameRunInEveryThread) {
  const Solver solver = line_solver(talker);
  const auto work = [&](int number) {
    std::vector<std::vector<Vector>> all;
    for (int k = 0; k < 5; ++k)
      all.push_back(points_of(run(sphere(2, 3), solver, {50}, number + k)));
    return all;
  };
  auto one = std::async(std::launch::async, work, 1);
  auto two = std::async(std::launch::async, work, 2);
  EXPECT_EQ(one.get(), work(1));
  EXPECT_EQ(two.get(), work(2));
}

TEST(LineSolver, DoesNotEndWithTheThreadThatMadeIt) {
  std::promise<Solver> made;
  std::promise<void> may_end;
  std::thread maker([&] {
    made.set_value(line_solver(talker));
    may_end.get_future().wait();
  });
  const Solver solver = made.get_future().get();
  Problem problem = sphere(2, 3);
  int calls = 0;
  problem.evaluate = [&, evaluate = problem.evaluate](const Vector& x) {
    if (++calls == 5) {
      may_end.set_value();
      maker.join();
    }
    return evaluate(x);
  };
  const RunRecord record = run(problem, solver, {20}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.ledger.charged, 20);
}

TEST(LineSolver, ServesStartAfterStartWithOneProgram) {
  const auto starts_of = [](const std::string& rest) {
    const std::string command = speaker(
        "echo started >> $HERE/starts; while hear; do say '{\"ask\": [1, 2]}'; hear; "
        "say '{\"done\": \"one asked\"}'; " +
        rest + " done");
    const RunRecord record = run(sphere(2, 3), line_solver(command), {5}, 0);
    EXPECT_EQ(record.failure, "");
    EXPECT_EQ(record.terminations.size(), 6U);
    const std::string starts = read(folder_of(command) / "starts");
    return std::count(starts.begin(), starts.end(), '\n');
  };
  EXPECT_EQ(starts_of(""), 1);
  EXPECT_EQ(starts_of("exit;"), 6) << "one that ends is started anew";
}

TEST(LineSolver, StartsAnotherInACopyOfTheProcess) {
  const Solver solver = line_solver(talker);
  const auto expected = points_of(run(sphere(2, 3), solver, {50}, 1));
  const pid_t copy = fork();
  if (copy == 0) _exit(points_of(run(sphere(2, 3), solver, {50}, 1)) == expected ? 0 : 1);
  int status = 0;
  waitpid(copy, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(points_of(run(sphere(2, 3), solver, {50}, 1)), expected);
}

TEST(LineSolver, MayEndWhenItIsToldToStop) {
  for (const char* end : {"exit 0", "exit 1", "kill -9 $$"}) {
    const Solver solver = line_solver(speaker(
        std::string("hear; while :; do say '{\"ask\": [1, 2]}'; hear; case $heard in *stop*) ") +
        end + ";; esac; done"));
    for (int number = 0; number < 2; ++number) {
      const RunRecord record = run(sphere(2, 3), solver, {5}, number);
      EXPECT_EQ(record.failure, "") << end;
      EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator")) << end;
    }
  }
}

TEST(LineSolver, HandsOverWhatItSays) {
  const RunRecord record =
      run(sphere(2, 3),
          line_solver(speaker("hear; say '{\"ask\": [3, 4]}'; hear; "
                              "say '{\"done\": \"found\", \"point\": [3, 3.5]}'; hear; exit")),
          {1}, 0);
  EXPECT_EQ(record.returned->x, (Vector{{3, 3.5}}));
  EXPECT_EQ(record.returned->true_values.objective, 0.25);
  EXPECT_EQ(reasons_of(record).front(), "found");
}

TEST(LineSolver, SeesWhatIsNoNumberAsNull) {
  const std::string command = speaker(
      R"(hear; say '{"ask": [1, 2]}'; hear; say "$heard" >> $HERE/heard; say '{"done": "seen"}')");
  run(never_a_number(2), line_solver(command), {2}, 0);
  EXPECT_EQ(read(folder_of(command) / "heard"),
            "{\"objective\":null,\"constraints\":[],\"remaining\":1}\n"
            "{\"objective\":null,\"constraints\":[],\"remaining\":0}\n"
            "{\"stop\":true}\n");
}

TEST(LineSolver, IsStoppedWhereTheProblemThrows) {
  const RunRecord record = run(breaks_after(7, 2), line_solver(talker), {100}, 0);
  EXPECT_EQ(record.failure, "broken scene");
  EXPECT_EQ(record.ledger.values, 7);
  EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator"));
}

TEST(LineSolver, FailsWhereTheRulesAreBroken) {
  EXPECT_EQ(
      failure_of("hear; say hello"),
      "output line 2 is no JSON (what is for people to read belongs on standard error): hello");
  EXPECT_EQ(failure_of("hear; say '[1, 2]'"), "output line 2 is no JSON object: [1, 2]");
  EXPECT_EQ(failure_of("hear; say '{}'"), "output line 2 has neither \"ask\" nor \"done\": {}");
  EXPECT_THAT(failure_of("hear; say '{\"ask\": [1, NaN]}'"), HasSubstr("is no JSON"));
  EXPECT_EQ(failure_of("hear; say '{\"ask\": [1, 2]}'; hear; say '{\"ask\": [1]}'"),
            "output line 3 ask must have 2 numbers: {\"ask\": [1]}");
  EXPECT_THAT(failure_of("hear; say '{\"ask\": []}'"), HasSubstr("ask must have 2 numbers: "));
  EXPECT_THAT(failure_of("hear; say '{\"ask\": 1}'"), HasSubstr("ask must have 2 numbers: "));
  EXPECT_THAT(failure_of("hear; say '{\"ask\": [\"1\", 2]}'"),
              HasSubstr("entry 1 is of type string"));
  EXPECT_THAT(failure_of("hear; say '{\"ask\": [[1, 2], 3]}'"),
              HasSubstr("ask must have 2 numbers in point 2"));
  EXPECT_THAT(failure_of("hear; say '{\"ask\": [1, 2], \"derivative\": true}'"),
              HasSubstr("derivative is not expected; did you mean derivatives?"));
  EXPECT_THAT(failure_of("hear; say '{\"ask\": [1, 2], \"derivatives\": 1}'"),
              HasSubstr("derivatives must be true or false"));
  EXPECT_THAT(failure_of("hear; say '{\"done\": true}'"),
              HasSubstr("\"done\" is no text in quotes"));
  EXPECT_THAT(failure_of("hear; say '{\"done\": \"\", \"point\": [1]}'"),
              HasSubstr("point must have 2 numbers"));
  EXPECT_THAT(failure_of("hear; say \"$(head -c 200 /dev/zero | tr '\\0' x)\""),
              testing::EndsWith("xxx..."));
  EXPECT_THAT(failure_of("hear; head -c 100000000 /dev/zero"),
              HasSubstr("a line of more than 4 MiB"));
}

TEST(LineSolver, FailsWhereTheProgramEndsOrGoesOnForever) {
  EXPECT_EQ(failure_of("hear; exit 3"), "ended with exit code 3 when it was given a problem");
  EXPECT_EQ(failure_of("hear; say '{\"ask\": [1, 2]}'; hear; exit 0"),
            "ended with exit code 0, and has not said that it is done");
  EXPECT_EQ(failure_of("hear; say '{\"ask\": [1, 2]}'; kill -SEGV $$"),
            "was ended by signal 11, Segmentation fault, and has not said that it is done");
  EXPECT_THAT(failure_of("while hear; do say '{\"ask\": [1, 2]}'; done"),
              HasSubstr("asks on, long after it was told to stop"));
  EXPECT_THAT(failure_of("yes '{\"ask\": [1, 2]}'"), testing::Not(""));
}

TEST(LineSolver, FailsWhereItSpeaksOutOfTurn) {
  const std::string failure = failure_of(
      "while hear; do say '{\"ask\": [1, 2]}'; hear; say '{\"done\": \"\"}\n{\"done\": \"\"}'; "
      "done");
  EXPECT_EQ(failure, "spoke after output line 3, when it was done");
}

TEST(LineSolver, DoesNotGoOnAfterAFailure) {
  const RunRecord record =
      run(sphere(2, 3), line_solver(speaker("while hear; do say '{}'; done")), {20}, 0);
  EXPECT_EQ(record.ledger.charged, 0);
  EXPECT_TRUE(record.terminations.empty());
}

TEST(LineSolver, IsRefusedWhereItDoesNotGreet) {
  const auto refused = [](const std::string& command, const std::string& reason) {
    try {
      line_solver(command);
      ADD_FAILURE() << command;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(command + ": "));
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  };
  refused("no-such-program at all", "ended with exit code 127: there is no such program, and has");
  refused("sh -c 'exit 2'", "ended with exit code 2, and has not said what it is");
  refused("echo hello", "output line 1 is no JSON");
  refused("echo '{\"nam\": \"mine\"}'", "knows no \"nam\"; did you mean name?");
  refused("echo '{}'", "name \"\"; allowed are");
  refused("echo '{\"name\": \"a b\"}'", "name \"a b\"; allowed are");
  refused("echo '{\"name\": \"a\", \"takes_constraints\": 3}'", "takes_constraints 3");
  refused("echo '{\"name\": \"a\", \"takes_constraints\": true}'", "is no whole number");
  refused("echo one | cat", "is not one program with its arguments");
  refused("echo 'one", "is not one program with its arguments");
  refused("echo $(ls)", "is not one program with its arguments");
}

}  // namespace
}  // namespace ricochet::outside
