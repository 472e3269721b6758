#include <gtest/gtest.h>

#include "src/studies/impact_test/tool.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

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

}  // namespace
}  // namespace ricochet::studies::impact_test
