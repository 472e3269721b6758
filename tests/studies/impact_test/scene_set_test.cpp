#include <gtest/gtest.h>

#include "src/studies/impact_test/scene_kinds.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

TEST(SceneSet, IsKeptAndContinued) {
  const ScratchFolder folder;
  const auto file = folder.path() / "scenes.jsonl";
  scene_set(5, 12, file);
  const std::string twelve = text_in(file);
  EXPECT_EQ(std::ranges::count(twelve, '\n'), 12);
  const auto more = scene_set(5, 15, file);
  EXPECT_EQ(more.size(), 15U);
  EXPECT_TRUE(text_in(file).starts_with(twelve));
  // Those that are there are not drawn again: a change in the file stays.
  std::string changed = text_in(file);
  changed.replace(changed.find("\"duration\":") + 11, 1, "9");
  write_file(file, changed);
  EXPECT_GE(scene_set(5, 15, file)[0].scene.duration, 9);
  EXPECT_EQ(scene_set(5, 3, file).size(), 3U);
  EXPECT_EQ(text_in(file), changed);
}

TEST(SceneSet, IsDrawnAgainForAnotherSeedOrAFileThatIsCutOff) {
  const ScratchFolder folder;
  const auto file = folder.path() / "scenes.jsonl";
  scene_set(5, 12, file);
  const std::string text = text_in(file);
  write_file(file, text.substr(0, text.size() - 100));
  scene_set(5, 12, file);
  EXPECT_EQ(text_in(file), text);
  EXPECT_EQ(scene_set(6, 2, file)[1].seed, 6);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
