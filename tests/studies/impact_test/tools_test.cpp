#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/studies/impact_test/score.h"
#include "src/studies/impact_test/simulator.h"
#include "tests/studies/impact_test/some_scenes.h"

/// Tools as they are, where they are installed: the others are skipped, and say so.
namespace ricochet::studies::impact_test {
namespace {

std::vector<Tool> all_tools() {
  return tools_in(RICOCHET_SOURCE "/src/studies/impact_test/tools/tools.toml");
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
  const std::string page = text_of_file(RICOCHET_SOURCE "/src/studies/impact_test/tools/README.md");
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
  if (!found.program) GTEST_SKIP() << tool->name << " " << found.reason;
  const Ask ask = simulator_of(*found.program, folder.path()).open(Level::usual);
  std::vector<ScoredScene> scenes;
  std::vector<Score> scores;
  for (int k = 0; k < 50; ++k) {
    scenes.push_back(drawn_scene(1, k));
    scores.push_back(score_of(ask(scenes.back()), scenes.back()));
  }
  const Tally tally = tally_of(scores, scenes, [](const TestScene&) { return true; });
  // An error may be the tool's own: SciPy 1.10 finds the same event again in two of these scenes.
  EXPECT_GE(tally.answered, 45);
  EXPECT_EQ(tally.answered + tally.cannot + tally.errors, 50);
  EXPECT_LE(*tally.per_thousand(tally.missed), 100);
  EXPECT_LE(*tally.per_thousand(tally.invented), 100);
  EXPECT_GT(*tally.seconds_per_impact, 0);
}

// What the build and the tests install anyway.
INSTANTIATE_TEST_SUITE_P(Installed, ImpactTools, testing::Values("scipy-rk45", "scipy-dop853"));

}  // namespace
}  // namespace ricochet::studies::impact_test
