#include "src/core/files.h"
#include "src/studies/simulators/suite.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet::studies::simulators {
namespace {

using testing::Optional;

/// A scene of ten seconds with impacts on the lower wall at the times 1, 2, ... and speed 1, which
/// need not be a motion. Slower impacts than 0.1 do not count.
ScoredScene with_impacts(int number, const std::string& name = "made") {
  ScoredScene scored;
  scored.scene.scene = name;
  scored.scene.kind = "bouncing";
  scored.scene.duration = number + 1;
  scored.scene.slowest = 0.1;
  for (int k = 1; k <= number; ++k) scored.truth.push_back({double(k), Wall::lower, 1, 0, 0});
  return scored;
}

/// The answer that has exactly the true impacts.
Answer right_answer(const ScoredScene& scored) {
  Answer answer{scored.scene.scene};
  for (const TrueImpact& i : scored.truth) answer.impacts.push_back({i.time, i.wall, i.speed});
  answer.seconds = 0.5;
  return answer;
}

TEST(Match, MakesTheMostPairsAndOfThoseTheNearest) {
  struct Row {
    std::vector<double> true_times, found_times;
    std::vector<std::optional<std::size_t>> partners;
  };
  const auto on_lower = [](const std::vector<double>& times) {
    std::vector<Impact> impacts;
    for (const double t : times) impacts.push_back({t, Wall::lower, 1});
    return impacts;
  };
  for (const Row& row : {
           // Greedily the first true one would take the second, and the last would have none.
           Row{{1, 1.5}, {0.6, 1.1}, {0, 1}},
           Row{{1}, {0.9, 1.01, 1.2}, {1}},
           Row{{1, 2, 3, 4}, {1.1, 3.1, 4.1}, {0, {}, 1, 2}},
           Row{{1}, {}, {{}}},
           Row{{1}, {1.6}, {{}}},
       }) {
    EXPECT_EQ(partners_of(on_lower(row.true_times), on_lower(row.found_times), 0.5), row.partners);
  }
  EXPECT_THAT(partners_of(on_lower({1}), {{1, Wall::upper, 1}}, 0.5), ElementsAre(std::nullopt));
}

/// Impacts that count, missed, invented, late and wrong ones.
std::array<int, 5> numbers_of(const Score& score) {
  return {score.impacts, score.missed, score.invented, score.late, score.wrong_speed};
}

TEST(Score, CountsEveryFaultOnce) {
  const ScoredScene scored = with_impacts(9);  // a second apart
  Answer answer = right_answer(scored);
  const Score right = score_of(answer, scored);
  EXPECT_THAT(numbers_of(right), ElementsAre(9, 0, 0, 0, 0));
  EXPECT_EQ(right.time_error, 0);
  EXPECT_EQ(right.penetration, 0);
  EXPECT_DOUBLE_EQ(*right.seconds_per_impact, 0.5 / 9);
  auto& impacts = answer.impacts;
  impacts[1].time += 0.02;                      // late
  impacts[2].speed *= 1.02;                     // wrong speed
  impacts[8].wall = Wall::upper;                // missed, and invented
  impacts.erase(impacts.begin() + 6);           // missed
  impacts.push_back({3.5, Wall::upper, 0.2});   // invented
  impacts.push_back({3.6, Wall::upper, 0.09});  // too slow to count
  impacts.push_back({11, Wall::lower, 1});      // behind the end
  std::ranges::stable_sort(impacts, {}, &Impact::time);
  answer.deepest = 1e-6;
  const Score score = score_of(answer, scored);
  EXPECT_THAT(numbers_of(score), ElementsAre(9, 2, 2, 1, 1));
  EXPECT_NEAR(*score.time_error, 0.02, 1e-12) << "up to the first that is lost or invented";
  EXPECT_EQ(score.penetration, 1e-6);
}

TEST(Score, DoesNotCountImpactsNextToTheLimit) {
  ScoredScene scored = with_impacts(4);
  scored.truth[1].speed = 0.101;  // counts
  scored.truth[2].speed = 0.099;  // does not
  Answer answer = right_answer(scored);
  answer.impacts[1].speed = 0.099;
  answer.impacts[2].speed = 0.101;
  const Score score = score_of(answer, scored);
  EXPECT_EQ(score.impacts, 3);
  EXPECT_EQ(score.wrong(), 0);
  answer.impacts.erase(answer.impacts.begin() + 2);
  EXPECT_EQ(score_of(answer, scored).wrong(), 0) << "a slow one is not missed";
  answer.impacts[1].speed = 0.049;
  EXPECT_EQ(score_of(answer, scored).missed, 1) << "one of less than half the limit is no partner";
}

TEST(Score, TakesAllImpactsFromWhoGivesNoAnswer) {
  const ScoredScene scored = with_impacts(5);
  for (const auto& [ending, missed] :
       {std::pair(Ending::never, 5), std::pair(Ending::error, 5), std::pair(Ending::cannot, 0)}) {
    EXPECT_THAT(numbers_of(score_of({"made", ending, "why"}, scored)),
                ElementsAre(missed, missed, 0, 0, 0));
  }
}

TEST(Tally, AddsUpScores) {
  const ScoredScene nine = with_impacts(9), two = with_impacts(2);
  Answer lossy = right_answer(nine);
  lossy.impacts.pop_back();
  const Tally all = tally_of({score_of(lossy, nine), score_of({"made", Ending::cannot, ""}, nine),
                              score_of({"made", Ending::never, ""}, two)});
  EXPECT_EQ(std::tuple(all.scenes, all.answered, all.cannot, all.errors, all.never, all.missed),
            std::tuple(3, 1, 1, 0, 1, 3));
  EXPECT_EQ(all.impacts, 11) << "without those of the scene that the tool cannot express";
  EXPECT_DOUBLE_EQ(*all.wrong(), 3000.0 / 11);
  EXPECT_FALSE(tally_of({}).wrong());
  EXPECT_EQ(median_of({3, 1, 2}), 2);
}

TEST(Answer, IsReadInAnyOrderOfImpacts) {
  const Answer answer = answer_in(
      R"({"scene":"a","impacts":[[2,"upper",0.5],[1,"lower",3]],"seconds":0.1,"deepest":1e-5,"end":[0,1]})",
      "a");
  EXPECT_THAT(answer,
              FieldsAre("a", Ending::answered, "",
                        ElementsAre(FieldsAre(1, Wall::lower, 3), FieldsAre(2, Wall::upper, 0.5)),
                        0.1, 1e-5));
}

TEST(Answer, IsAnErrorIfItIsNone) {
  for (const char* line :
       {"", "Traceback:", "[]", R"({"scene":"a"})", R"({"scene":"b","impacts":[],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"left",1]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower"]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower",null]],"seconds":1})",
        R"({"scene":"a","impacts":[],"seconds":-1})", R"({"scene":"a","error":7})"}) {
    const Answer answer = answer_in(line, "a");
    EXPECT_EQ(answer.ending, Ending::error) << line;
    EXPECT_THAT(answer.reason, HasSubstr("no answer")) << line;
  }
}

TEST(Answer, IsWrittenAsItIsRead) {
  EXPECT_THAT(answer_in(line_of(right_answer(with_impacts(3))), "made"),
              FieldsAre("made", Ending::answered, "",
                        ElementsAre(FieldsAre(1, Wall::lower, 1), FieldsAre(2, Wall::lower, 1),
                                    FieldsAre(3, Wall::lower, 1)),
                        0.5, 0));
  for (const Ending ending : {Ending::cannot, Ending::error, Ending::never}) {
    const Answer back = answer_in(line_of({"made", ending, "why"}), "made");
    EXPECT_EQ(back.ending, ending);
    EXPECT_EQ(back.reason, "why");
  }
}

const std::string tools_text = R"(
[[tool]]
name = "some"
title = "Some tool"
kind = "event location"
packages = ["some-dev"]
source = "some.cpp"
compile = "$CXX $SOURCE -o $OUT"
run = ["$OUT", "fast"]
version = ["echo 1"]
loose = "1e-4"
usual = "1e-6"
tight = "1e-12"
sets = "both"
advice = "none"
)";

TEST(Tool, IsReadFromAFileOrRefused) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& text) {
    return tools_in(write_file(folder.path() / "tools.toml", text));
  };
  const auto tools = read(tools_text);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].name, "some");
  EXPECT_THAT(tools[0].run, ElementsAre("$OUT", "fast"));
  EXPECT_EQ(tools[0].source, folder.path() / "some.cpp");
  EXPECT_EQ(tools[0].levels[static_cast<std::size_t>(Level::tight)], "1e-12");
  const auto with = [](const std::string& from, const std::string& to) {
    std::string changed = tools_text;
    return changed.replace(changed.find(from), from.size(), to);
  };
  expect_refusals(read, {{with("title", "titel"), "there is no key titel"},
                         {with("run = [\"$OUT\", \"fast\"]", ""), "run is missing"},
                         {with("[\"some-dev\"]", "7"), "packages = 7: must be a text"},
                         {with("\"some\"", "\"a/b\""), "a/b"},
                         {tools_text + with("1e-4", "1e-3"), "twice"}});
}

TEST(Tool, MayBeOnesOwn) {
  const Tool tool = own_tool("mine=python3 my.py  fast");
  EXPECT_EQ(tool.name, "mine");
  EXPECT_THAT(tool.run, ElementsAre("python3", "my.py", "fast"));
  for (const char* wrong : {"", "mine", "mine=", "=x", "a/b=x"})
    EXPECT_THROW(own_tool(wrong), InputError) << wrong;
}

/// A tool whose driver is "compiled" by copying it.
Tool copied_tool(const fs::path& folder) {
  Tool tool;
  tool.name = "copied";
  tool.source = write_file(folder / "driver.sh", "#!/bin/sh\necho 3.1\n");
  tool.compile = "cp $SOURCE $OUT && chmod +x $OUT";
  tool.run = {"$OUT", "$HERE/data"};
  tool.version = {"$OUT", "--version"};
  return tool;
}

TEST(ToolProgram, IsCompiledOnceAndTellsItsVersion) {
  const ScratchFolder folder;
  const Tool tool = copied_tool(folder.path());
  const FoundTool found = found_tool(tool, folder.path() / "drivers");
  ASSERT_EQ(found.reason, "");
  EXPECT_EQ(found.version, "3.1");
  const std::string driver = found.command.at(0);
  EXPECT_TRUE(fs::exists(driver));
  EXPECT_EQ(found.command.at(1), (folder.path() / "data").string());
  const auto made = fs::last_write_time(driver);
  EXPECT_EQ(found_tool(tool, folder.path() / "drivers").command.at(0), driver);
  EXPECT_EQ(fs::last_write_time(driver), made);
  write_file(tool.source, "#!/bin/sh\necho 3.2\n");
  EXPECT_EQ(found_tool(tool, folder.path() / "drivers").version, "3.2");
}

TEST(ToolProgram, SaysWhyItIsNotThere) {
  const ScratchFolder folder;
  Tool tool = copied_tool(folder.path());
  tool.version = {"echo no module named x >&2; exit 1"};
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("no module named x"));
  tool.version = {"no-such-program-at-all", "--version"};
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("not installed"));
  tool.compile = "echo header.h is missing >&2; false";
  EXPECT_THAT(found_tool(tool, folder.path()).reason, HasSubstr("header.h is missing"));
}

/// A session at the level "tight" with a shell script that answers a line by the scene's name.
ToolSession session_with(const fs::path& folder, const std::string& cases) {
  FoundTool found;
  found.tool.name = "fake";
  found.command = {"sh", "-c", "while read -r line; do case $line in\n" + cases + "esac; done"};
  return {found, Level::tight, folder / "log", {std::chrono::seconds(20), std::chrono::seconds(1)}};
}

TestScene named(const std::string& name) {
  TestScene scene;
  scene.scene = name;
  scene.force = {{0, {}}};
  return scene;
}

TEST(ToolSession, OutlivesWhatTheToolDoes) {
  const ScratchFolder folder;
  ToolSession session = session_with(folder.path(), R"(
*'"good"'*) echo '{"scene":"good","impacts":[[1,"lower",1]],"seconds":0.1}';;
*'"cannot"'*) echo "{\"scene\":\"cannot\",\"cannot\":\"$0\"}";;
*'"crash"'*) echo "memory is full" >&2; exit 3;;
*'"hang"'*) sleep 100;;
)");
  EXPECT_EQ(session.ask(named("good")).impacts.size(), 1U);
  const Answer cannot = session.ask(named("cannot"));
  EXPECT_EQ(cannot.ending, Ending::cannot);
  EXPECT_EQ(cannot.reason, "tight") << "it is told its level";
  const Answer crash = session.ask(named("crash"));
  EXPECT_EQ(crash.ending, Ending::error);
  EXPECT_THAT(crash.reason, AllOf(HasSubstr("exit code 3"), HasSubstr("memory is full")));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered) << "it is started again";
  const Answer hang = session.ask(named("hang"));
  EXPECT_EQ(hang.ending, Ending::never);
  EXPECT_THAT(hang.reason, HasSubstr("1 s"));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered);
}

TEST(ToolSession, GivesUpAToolThatNeverStarts) {
  const ScratchFolder folder;
  FoundTool missing;
  missing.command = {"no-such-program-at-all"};
  ToolSession session(missing, Level::usual, folder.path() / "log");
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_THROW(session.ask(named("good")), ToolFailure);
}

const std::vector<ScoredScene> three_scenes = {with_impacts(2, "a"), with_impacts(2, "b"),
                                               with_impacts(2, "c")};

/// How often somebody, who is killed at `last`, is asked for their answers, which are kept in the
/// file.
int asked_for(const fs::path& file, const std::string& origin = "origin", int last = 100) {
  int asked = 0;
  const auto answers = kept_answers(file, origin, three_scenes, [&](const ScoredScene& scored) {
    if (asked == last) throw std::runtime_error("killed");
    ++asked;
    return right_answer(scored);
  });
  EXPECT_EQ(answers.size(), three_scenes.size());
  for (std::size_t k = 0; k < answers.size(); ++k)
    EXPECT_EQ(line_of(answers[k]), line_of(right_answer(three_scenes[k])));
  return asked;
}

TEST(KeptAnswers, GoOnWhereTheyWereInterrupted) {
  const ScratchFolder folder;
  const auto file = folder.path() / "answers" / "tool.jsonl";
  EXPECT_THROW(asked_for(file, "origin", 2), std::runtime_error);
  EXPECT_EQ(asked_for(file), 1);
  EXPECT_EQ(asked_for(file), 0);
  EXPECT_EQ(asked_for(file, "another version"), 3);
}

TEST(KeptAnswers, AskAgainForALineThatIsCutOff) {
  const ScratchFolder folder;
  const auto file = folder.path() / "tool.jsonl";
  EXPECT_EQ(asked_for(file), 3);
  const std::string text = text_of(file);
  for (const std::size_t left : {text.size() - 1, text.size() - 20}) {
    write_file(file, text.substr(0, left));
    EXPECT_EQ(asked_for(file), 1);
    EXPECT_EQ(text_of(file), text);
  }
}

const fs::path tools_folder = RICOCHET_SOURCE "/src/studies/simulators/tools";

TEST(ImpactTools, AreDescribedInFull) {
  for (const Tool& tool : tools_in(tools_folder / "tools.toml")) {
    EXPECT_TRUE(fs::exists(tool.source)) << tool.source;
    for (const std::string& level : tool.levels) EXPECT_NE(level, "") << tool.name;
    EXPECT_NE(tool.sets, "") << tool.name;
    EXPECT_NE(tool.advice, "") << tool.name;
  }
}

TEST(ImpactTools, HaveEveryKeyInTheirReadme) {
  const ScratchFolder folder;
  const auto file = write_file(folder.path() / "tools.toml", "[[tool]]\nqqqqqqqq = 1\n");
  const std::string said = complaint_of([&] { return tools_in(file); });
  const std::size_t list = said.find("allowed: ");
  ASSERT_NE(list, std::string::npos) << said;
  const std::string page = text_of(tools_folder / "README.md");
  std::istringstream words(said.substr(list + 9));
  int keys = 0;
  for (std::string word; words >> word; ++keys)
    EXPECT_THAT(page, HasSubstr('`' + word.substr(0, word.find(',')) + '`'));
  EXPECT_EQ(keys, 13);
}

TEST(ImpactTools, AnswerFiftyScenes) {
  const std::vector<Tool> tools = tools_in(tools_folder / "tools.toml");
  // What the build and the tests install anyway.
  const auto tool = std::ranges::find(tools, "scipy-rk45", &Tool::name);
  ASSERT_NE(tool, tools.end());
  const ScratchFolder folder;
  const FoundTool found = found_tool(*tool, folder.path());
  if (!found.reason.empty()) GTEST_SKIP() << tool->name << " " << found.reason;
  const Ask ask = simulator_of(found, folder.path()).open(Level::usual);
  std::vector<Score> scores;
  for (int k = 0; k < 50; ++k) {
    const ScoredScene scored = drawn_scene(1, k);
    scores.push_back(score_of(ask(scored), scored));
  }
  const Tally tally = tally_of(scores);
  // An error may be the tool's own: SciPy 1.10 finds the same event again in two of these scenes.
  EXPECT_GE(tally.answered, 45);
  EXPECT_EQ(tally.answered + tally.cannot + tally.errors, 50);
  EXPECT_LE(*tally.per_thousand(tally.missed), 100);
  EXPECT_LE(*tally.per_thousand(tally.invented), 100);
  EXPECT_GT(*tally.seconds_per_impact, 0);
}

}  // namespace
}  // namespace ricochet::studies::simulators
