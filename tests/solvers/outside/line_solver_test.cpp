#include "solvers/outside/line_solver.h"

#include <future>

#include "tests/solvers/solve.h"

namespace ricochet::outside {
namespace {

const std::string talker = RICOCHET_FOLDER "/talker";

/// A script that greets, and then does what its lines say; `say` writes a line, `hear` reads one or
/// ends, and `note` reads one that heard() tells. `ask` asks for a point.
struct Speaker {
  explicit Speaker(const std::string& lines, const std::string& greeting = R"({"name": "mine"})") {
    write_file(folder / "script.sh", "HERE=" + folder.string() + R"(
say() { echo "$1"; }
hear() { read -r heard || exit 0; }
note() { hear; say "$heard" >> $HERE/heard; }
ask() { say '{"ask": [1, 2]}'; hear; }
say ')" + greeting + "'\n" + lines + "\n");
  }

  std::string heard() const { return text_of(folder / "heard"); }
  Solver solver() const { return line_solver(command); }

  const fs::path folder = fresh_folder();
  const std::string command = "sh " + (folder / "script.sh").string();
};

RunRecord run_of(const Speaker& speaker, std::int64_t evaluations = 20) {
  return run(sphere(2, 3), speaker.solver(), {evaluations}, 0);
}

TEST(LineSolver, IsWhatTheProgramSaysItIs) {
  const Solver plain = Speaker("hear", R"({"name": "a"})").solver();
  EXPECT_EQ(plain.name, "a");
  EXPECT_FALSE(plain.stochastic);
  EXPECT_EQ(plain.capabilities, Capabilities{});
  const Solver rich = Speaker("hear", R"({"name": "b", "version": "7", "takes_constraints": 2,)"
                                      R"( "needs_derivatives": true, "stochastic": true})")
                          .solver();
  EXPECT_EQ(rich.name, "b");
  EXPECT_EQ(rich.version, "7");
  EXPECT_TRUE(rich.stochastic);
  EXPECT_EQ(rich.capabilities, (Capabilities{.constraints = Capabilities::Constraints::all,
                                             .derivatives = Capabilities::Order::gradient}));
}

TEST(LineSolver, SpeaksAsTheReadmeSays) {
  const Speaker speaker(R"(note
for line in '{"ask": [1, 2]}' '{"ask": [1, 2], "derivatives": true}' '{"ask": [[0, 0], [3, 3]]}' \
            '{"ask": [-5, null]}' '{"ask": [0, 0]}'; do
  say "$line"; note
done
say '{"done": "all asked", "point": [1, 2]}')",
                        R"({"name": "mine", "takes_constraints": 2})");
  const RunRecord record = run(arc(), speaker.solver(), {20}, 0);
  EXPECT_EQ(record.failure, "");
  EXPECT_EQ(record.termination_reason, TerminationReason::bad_point);
  EXPECT_EQ(record.ledger.charged, 1 + 2 + 2) << "derivatives where the values are known cost 2";
  EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator"));
  EXPECT_EQ(record.returned->x, (Vector{{1, 2}}));
  EXPECT_THAT(
      speaker.heard(),
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
  const Speaker speaker(R"(hear
for line in '{"ask": [[1, 3], [4, 3]], "residuals": true}' \
            '{"ask": [4, 3], "residuals": true, "derivatives": true}'; do
  say "$line"; note
done
say '{"done": "all asked"}')",
                        R"({"name": "mine", "needs_residuals": true})");
  EXPECT_EQ(speaker.solver().capabilities, Capabilities{.needs_residuals = true});
  Problem problem = sphere(2, 3);
  problem.residuals = [](const Vector& x) {
    return Residuals{x.array() - 3, 2 * Matrix::Identity(2, 2)};
  };
  solved(problem, speaker.solver(), 4);
  EXPECT_EQ(speaker.heard(), R"({"residuals":[[-2.0,0.0],[1.0,0.0]],"remaining":2}
{"residuals":[1.0,0.0],"residual_jacobian":[[2.0,0.0],[0.0,2.0]],"remaining":0}
)");
}

TEST(LineSolver, SeesWhatIsNoNumberAsNull) {
  const Speaker speaker(
      R"(hear; say '{"ask": [[1, 2]]}'; note; say '{"ask": [[70, 2], [1, 2]]}'; note)");
  run(half_a_number(), speaker.solver(), {3}, 0);
  EXPECT_EQ(speaker.heard(), R"({"objective":[5.0],"constraints":[[]],"remaining":2}
{"objective":[null,5.0],"constraints":[[],[]],"remaining":0}
)");
}

TEST(LineSolver, MakesTheSameRunAgain) {
  const auto improvements = [](const Solver& solver, int number) {
    return points_of(run(sphere(3, 3), solver, {200}, number));
  };
  const Solver solver = line_solver(talker);
  const std::vector<Vector> first = improvements(solver, 1);
  EXPECT_NE(improvements(solver, 2), first);
  EXPECT_EQ(improvements(line_solver("sh -c '" + talker + "'"), 1), first);
  EXPECT_TRUE(holds_in_a_copy([&] { return improvements(solver, 1) == first; }));
  EXPECT_EQ(improvements(solver, 1), first) << "the copy has started a program of its own";
  const Solver in_batches = line_solver(talker + " 7");
  EXPECT_EQ(improvements(in_batches, 1), first) << "all the same";
  for (const std::int64_t budget : {0, 1, 20, 1000}) {
    const RunRecord record = run(sphere(2, 3), in_batches, {budget}, 0);
    EXPECT_EQ(record.ledger.charged, budget);
    EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator"));
  }
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
  for (const auto& [rest, starts] :
       {std::pair("", "s\n"), std::pair("exit;", "s\ns\ns\ns\ns\ns\n")}) {
    const Speaker speaker(std::string("echo s >> $HERE/heard; while hear; do ask; "
                                      "say '{\"done\": \"one asked\"}'; ") +
                          rest + " done");
    const RunRecord record = run_of(speaker, 5);
    EXPECT_EQ(record.failure, "");
    EXPECT_EQ(record.terminations.size(), 6U);
    EXPECT_EQ(speaker.heard(), starts) << "one that ends is started anew";
  }
}

TEST(LineSolver, MayEndWhenItIsToldToStop) {
  for (const std::string end : {"exit 0", "exit 1", "kill -9 $$"}) {
    const Speaker speaker("hear; while :; do ask; case $heard in *stop*) " + end + ";; esac; done");
    const Solver solver = speaker.solver();
    for (int number = 0; number < 2; ++number) {
      const RunRecord record = run(sphere(2, 3), solver, {5}, number);
      EXPECT_EQ(record.failure, "") << end;
      EXPECT_THAT(reasons_of(record), ElementsAre("stopped by the evaluator")) << end;
    }
  }
}

TEST(LineSolver, HandsOverWhatItSays) {
  const RunRecord record = run_of(Speaker(R"(hear; say '{"ask": [3, 4]}'; hear
say '{"done": "found", "point": [3, 3.5]}'; hear)"),
                                  1);
  EXPECT_EQ(record.returned->x, (Vector{{3, 3.5}}));
  EXPECT_EQ(record.returned->true_values.objective, 0.25);
  EXPECT_EQ(reasons_of(record).front(), "found");
}

/// What a run of a script on the plane is said to have failed with, after its command.
std::string failure_of(const std::string& lines) {
  const Speaker speaker(lines);
  const RunRecord record = run_of(speaker);
  EXPECT_THAT(record.failure, StartsWith(speaker.command + ": "));
  EXPECT_TRUE(record.terminations.empty()) << lines;
  return record.failure.substr(std::min(record.failure.size(), speaker.command.size() + 2));
}

TEST(LineSolver, FailsWhereTheRulesAreBroken) {
  const char* no_json = " is no JSON (what is for people to read belongs on standard error)";
  const std::pair<const char*, const char*> failures[] = {
      {"hello", no_json},
      {R"({"ask": [1, NaN]})", no_json},
      {"[1, 2]", " is no JSON object"},
      {"{}", R"( has neither "ask" nor "done")"},
      {R"({"ask": [1]})", " ask must have 2 numbers"},
      {R"({"ask": [1, 2], "derivative": true})",
       " derivative is not expected; did you mean derivatives?"},
      {R"({"done": true})", R"( "done" is no text in quotes)"},
      {R"({"done": "", "point": [1]})", " point must have 2 numbers"}};
  for (const auto& [line, failure] : failures) {
    const std::string end = std::string(failure) + ": " + line;
    EXPECT_EQ(failure_of(std::string("hear; say '") + line + "'"), "output line 2" + end);
    EXPECT_EQ(failure_of(std::string("hear; ask; say '") + line + "'"), "output line 3" + end);
  }
  EXPECT_THAT(failure_of("hear; say \"$(head -c 200 /dev/zero | tr '\\0' x)\""),
              EndsWith("xxx..."));
}

TEST(LineSolver, FailsWhereTheProgramEndsOrGoesOnForever) {
  EXPECT_EQ(failure_of("hear; exit 3"), "ended with exit code 3 when it was given a problem");
  EXPECT_EQ(failure_of("hear; ask; exit 0"),
            "ended with exit code 0, and has not said that it is done");
  EXPECT_EQ(failure_of("hear; say '{\"ask\": [1, 2]}'; kill -SEGV $$"),
            "was ended by signal 11, Segmentation fault, and has not said that it is done");
  EXPECT_THAT(failure_of("while hear; do say '{\"ask\": [1, 2]}'; done"),
              HasSubstr("asks on, long after it was told to stop"));
  EXPECT_NE(failure_of("yes '{\"ask\": [1, 2]}'"), "");
}

TEST(LineSolver, FailsWhereItSpeaksOutOfTurnAndDoesNotGoOn) {
  const RunRecord record =
      run_of(Speaker("while hear; do ask; say '{\"done\": \"\"}\n{\"done\": \"\"}'; done"));
  EXPECT_THAT(record.failure, EndsWith(": spoke after output line 3, when it was done"));
  EXPECT_EQ(run_of(Speaker("while hear; do say '{}'; done")).ledger.charged, 0);
}

TEST(LineSolver, IsRefusedWhereItDoesNotGreet) {
  expect_named_refusals(
      line_solver,
      {{"no-such-program at all", "ended with exit code 127: there is no such program, and has"},
       {"sh -c 'exit 2'", "ended with exit code 2, and has not said what it is"},
       {"echo hello", "output line 1 is no JSON"},
       {"echo '{\"nam\": \"mine\"}'", "knows no \"nam\"; did you mean name?"},
       {"echo '{}'", "name \"\"; allowed are"},
       {"echo '{\"name\": \"a\", \"takes_constraints\": 3}'",
        "takes_constraints 3; allowed are 0, 1"},
       {"echo '{\"name\": \"a\", \"takes_constraints\": true}'", "is no whole number"},
       {"echo one | cat", "is not one program with its arguments"},
       {"echo 'one", "is not one program with its arguments"},
       {"echo $(ls)", "is not one program with its arguments"}});
}

}  // namespace
}  // namespace ricochet::outside
