#include "src/live/machine_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/error.h"
#include "src/live/flat_scene.h"

namespace ricochet::live {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string complaint_about(const std::string& text) {
  try {
    machine_file(text, "own.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(MachineFile, HasTheNumbersOfTheScene) {
  carrier_track::RandomScenes random(6);
  for (int k = 0; k < 20; ++k) {
    const Scene scene = random.next();
    const MachineFile file = machine_file(write_scene(scene), "own.toml");
    EXPECT_EQ(write_scene(scene_of(file.numbers)), write_scene(scene));
    EXPECT_THAT(file.notes, IsEmpty());
  }
}

TEST(MachineFile, NotesWhatThePageLeavesOut) {
  std::string text = write_scene(Scene{});
  const std::string mass = "\nmass = ";
  const std::size_t begin = text.find(mass) + mass.size();
  text.replace(begin, text.find('\n', begin) - begin, "{ value = 2, plus_minus = 0.5 }");
  EXPECT_THAT(machine_file(text, "own.toml").notes,
              ElementsAre("scene.mass is uncertain in the file: taken at its value, 2"));
  Scene scene;
  scene.across.emplace();
  EXPECT_THAT(machine_file(write_scene(scene), "own.toml").notes,
              ElementsAre(HasSubstr("[across] is left out")));
}

TEST(MachineFile, RefusesWhatThePageCannotShow) {
  Scene scene;
  scene.profile = {{0, 0}, {1, 6}};
  EXPECT_THAT(complaint_about(write_scene(scene)),
              AllOf(HasSubstr("own.toml: scene.omega"), HasSubstr("profile")));
  EXPECT_THAT(complaint_about("[scene]\nmas = 1\n[window]\nseconds = 1\n"),
              HasSubstr("own.toml: there is no key scene.mas"));
}

}  // namespace
}  // namespace ricochet::live
