#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "ricochet/error.h"
#include "tests/studies/simulators/some_scenes.h"

namespace ricochet::studies::simulators {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* text = R"(
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

TEST(Tool, IsReadFromAFile) {
  const ScratchFolder folder;
  const auto tools = tools_in(write_file(folder.path() / "tools.toml", text));
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].name, "some");
  EXPECT_THAT(tools[0].run, ElementsAre("$OUT", "fast"));
  EXPECT_EQ(tools[0].source, folder.path() / "some.cpp");
  EXPECT_EQ(tools[0].levels[static_cast<std::size_t>(Level::tight)], "1e-12");
}

TEST(Tool, IsRefusedWhereTheFileIsWrong) {
  const ScratchFolder folder;
  const auto complaint = [&](std::string changed, const std::string& from, const std::string& to) {
    changed.replace(changed.find(from), from.size(), to);
    try {
      tools_in(write_file(folder.path() / "tools.toml", changed));
      return std::string("none");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(complaint(text, "title", "titel"), HasSubstr("there is no key titel"));
  EXPECT_THAT(complaint(text, "run = [\"$OUT\", \"fast\"]", ""), HasSubstr("run is missing"));
  EXPECT_THAT(complaint(text, "[\"some-dev\"]", "7"), HasSubstr("packages = 7: must be a text"));
  EXPECT_THAT(complaint(text, "\"some\"", "\"a/b\""), HasSubstr("a/b"));
  EXPECT_THAT(complaint(std::string(text) + text, "1e-4", "1e-3"), HasSubstr("twice"));
}

TEST(Tool, MayBeOnesOwn) {
  const Tool tool = own_tool("mine=python3 my.py  fast");
  EXPECT_EQ(tool.name, "mine");
  EXPECT_THAT(tool.run, ElementsAre("python3", "my.py", "fast"));
  for (const char* wrong : {"", "mine", "mine=", "=x", "a/b=x"}) {
    EXPECT_THROW(own_tool(wrong), InputError) << wrong;
  }
}

/// A tool whose driver is "compiled" by copying it.
Tool copied_tool(const std::filesystem::path& folder) {
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
  Tool tool = copied_tool(folder.path());
  const FoundTool found = found_tool(tool, folder.path() / "drivers");
  ASSERT_EQ(found.reason, "");
  EXPECT_EQ(found.version, "3.1");
  const std::string driver = found.command.at(0);
  EXPECT_TRUE(std::filesystem::exists(driver));
  EXPECT_EQ(found.command.at(1), (folder.path() / "data").string());
  const auto made = std::filesystem::last_write_time(driver);
  EXPECT_EQ(found_tool(tool, folder.path() / "drivers").command.at(0), driver);
  EXPECT_EQ(std::filesystem::last_write_time(driver), made);
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

/// A shell script that answers scenes by their names.
FoundTool script(const std::filesystem::path& folder, const std::string& body) {
  const auto file = write_file(folder / "tool.sh",
                               "while read -r line; do case $line in\n" + body + "esac; done\n");
  FoundTool program;
  program.tool.name = "fake";
  program.command = {"sh", file.string()};
  return program;
}

TestScene named(const std::string& name) {
  TestScene scene;
  scene.scene = name;
  scene.force = {{0, {}}};
  return scene;
}

constexpr const char* body = R"(
*'"good"'*) echo '{"scene":"good","impacts":[[1,"lower",1]],"seconds":0.1}';;
*'"cannot"'*) echo '{"scene":"cannot","cannot":"no"}';;
*'"crash"'*) echo "memory is full" >&2; exit 3;;
*'"hang"'*) sleep 100;;
)";

TEST(ToolSession, OutlivesWhatTheToolDoes) {
  const ScratchFolder folder;
  ToolSession session(script(folder.path(), body), Level::usual, folder.path() / "log",
                      {std::chrono::seconds(20), std::chrono::seconds(1)});
  EXPECT_EQ(session.ask(named("good")).impacts.size(), 1U);
  EXPECT_EQ(session.ask(named("cannot")).ending, Ending::cannot);
  const Answer crash = session.ask(named("crash"));
  EXPECT_EQ(crash.ending, Ending::error);
  EXPECT_THAT(crash.reason, HasSubstr("exit code 3"));
  EXPECT_THAT(crash.reason, HasSubstr("memory is full"));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered) << "it is started again";
  const Answer hang = session.ask(named("hang"));
  EXPECT_EQ(hang.ending, Ending::never);
  EXPECT_THAT(hang.reason, HasSubstr("1 s"));
  EXPECT_EQ(session.ask(named("good")).ending, Ending::answered);
}

TEST(ToolSession, GivesUpAToolThatNeverStarts) {
  const ScratchFolder folder;
  FoundTool program;
  program.command = {"no-such-program-at-all"};
  ToolSession session(program, Level::usual, folder.path() / "log");
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_EQ(session.ask(named("good")).ending, Ending::error);
  EXPECT_THROW(session.ask(named("good")), ToolFailure);
}

TEST(ToolSession, TellsTheToolItsLevel) {
  const ScratchFolder folder;
  FoundTool program;
  program.command = {"sh", "-c", R"(read -r line; echo "{\"scene\":\"a\",\"cannot\":\"$0\"}")"};
  ToolSession session(program, Level::tight, folder.path() / "log");
  EXPECT_EQ(session.ask(named("a")).reason, "tight");
}

TEST(ToolSession, IsScoredForEveryThirdImpactThatItMisses) {
  const ScratchFolder folder;
  const ScoredScene scored = with_impacts(9);
  ToolSession session(
      script(folder.path(),
             R"(*) echo '{"scene":"made","impacts":[[1,"lower",1],[2,"lower",1],[4,"lower",1],)"
             R"([5,"lower",1],[7,"lower",1],[8,"lower",1]],"seconds":0.1}';;
)"),
      Level::usual, folder.path() / "log");
  const Score score = score_of(session.ask(scored.scene), scored);
  EXPECT_EQ(score.missed, 3);
  EXPECT_EQ(score.invented, 0);
  EXPECT_EQ(score.late, 0);
}

std::vector<ScoredScene> three_scenes() {
  std::vector<ScoredScene> scenes;
  for (const char* name : {"a", "b", "c"}) {
    scenes.push_back(with_impacts(2));
    scenes.back().scene.scene = name;
  }
  return scenes;
}

/// Counts how often it is asked; throws in place of the last answers.
struct Asked {
  int answers = 0;
  int most = 100;

  Answer operator()(const ScoredScene& scored) {
    if (answers == most) throw std::runtime_error("killed");
    ++answers;
    return right_answer(scored);
  }
};

TEST(KeptAnswers, GoOnWhereTheyWereInterrupted) {
  const ScratchFolder folder;
  const auto file = folder.path() / "answers" / "tool.jsonl";
  const auto scenes = three_scenes();
  Asked first{0, 2};
  EXPECT_THROW(kept_answers(file, "origin", scenes, std::ref(first)), std::runtime_error);
  Asked second;
  const auto answers = kept_answers(file, "origin", scenes, std::ref(second));
  EXPECT_EQ(second.answers, 1);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].scene, "a");
  EXPECT_EQ(answers[2].impacts.size(), 2U);
  Asked third;
  kept_answers(file, "origin", scenes, std::ref(third));
  EXPECT_EQ(third.answers, 0);
}

TEST(KeptAnswers, AskAgainForALineThatIsCutOff) {
  const ScratchFolder folder;
  const auto file = folder.path() / "tool.jsonl";
  Asked first;
  kept_answers(file, "origin", three_scenes(), std::ref(first));
  const std::string text = text_in(file);
  for (const std::size_t left : {text.size() - 1, text.size() - 20}) {
    write_file(file, text.substr(0, left));
    Asked second;
    EXPECT_EQ(kept_answers(file, "origin", three_scenes(), std::ref(second)).size(), 3U);
    EXPECT_EQ(second.answers, 1);
    EXPECT_EQ(text_in(file), text);
  }
}

TEST(KeptAnswers, AreThoseOfTheSameOriginAlone) {
  const ScratchFolder folder;
  const auto file = folder.path() / "tool.jsonl";
  Asked first, second;
  kept_answers(file, "version 1", three_scenes(), std::ref(first));
  kept_answers(file, "version 2", three_scenes(), std::ref(second));
  EXPECT_EQ(second.answers, 3);
}

std::vector<Tool> all_tools() {
  return tools_in(RICOCHET_SOURCE "/src/studies/simulators/tools/tools.toml");
}

TEST(ImpactTools, AreDescribedInFull) {
  for (const Tool& tool : all_tools()) {
    EXPECT_TRUE(std::filesystem::exists(tool.source)) << tool.source;
    for (const std::string& level : tool.levels) EXPECT_NE(level, "") << tool.name;
    EXPECT_NE(tool.sets, "") << tool.name;
    EXPECT_NE(tool.advice, "") << tool.name;
  }
}

TEST(ImpactTools, HaveEveryKeyInTheirReadme) {
  const ScratchFolder folder;
  std::string said;
  try {
    tools_in(write_file(folder.path() / "tools.toml", "[[tool]]\nqqqqqqqq = 1\n"));
  } catch (const InputError& error) {
    said = error.what();
  }
  const std::size_t list = said.find("allowed: ");
  ASSERT_NE(list, std::string::npos) << said;
  const std::string page = text_of_file(RICOCHET_SOURCE "/src/studies/simulators/tools/README.md");
  std::istringstream words(said.substr(list + 9));
  int keys = 0;
  for (std::string word; words >> word; ++keys) {
    const std::string key = word.substr(0, word.find(','));
    EXPECT_NE(page.find('`' + key + '`'), std::string::npos) << key;
  }
  EXPECT_EQ(keys, 13);
}

class ImpactTools : public testing::TestWithParam<const char*> {};

TEST_P(ImpactTools, AnswerFiftyScenes) {
  const std::vector<Tool> tools = all_tools();
  const auto tool = std::ranges::find(tools, GetParam(), &Tool::name);
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

// What the build and the tests install anyway.
INSTANTIATE_TEST_SUITE_P(Installed, ImpactTools, testing::Values("scipy-rk45"));

}  // namespace
}  // namespace ricochet::studies::simulators
