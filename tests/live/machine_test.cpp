#include <regex>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "ricochet/error.h"
#include "src/live/count_there.h"
#include "src/live/flat_scene.h"
#include "src/live/machine_file.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

/// A machine as the live page has it: as numbers, as a file, and its count.
namespace ricochet::live {
namespace {

using carrier_track::RandomScenes;

std::size_t place_of(const std::string& key) {
  const std::vector<FlatField> fields = flat_fields();
  const auto at = std::ranges::find(fields, key, &FlatField::key);
  EXPECT_NE(at, fields.end()) << key;
  return static_cast<std::size_t>(at - fields.begin());
}

TEST(FlatScene, ComesBackAsTheSameFileWhichHasTheSameNumbers) {
  RandomScenes random(5);
  for (int k = 0; k < 200; ++k) {
    Scene scene = random.next();
    if (k % 3 == 0) scene.contact_speed = 0.25;
    const std::string text = write_scene(scene);
    const std::vector<double> numbers = numbers_of(scene);
    EXPECT_EQ(numbers.size(), flat_fields().size());
    EXPECT_EQ(write_scene(scene_of(numbers)), text);
    if (k >= 20) continue;
    const MachineFile file = machine_file(text, "own.toml");
    EXPECT_EQ(write_scene(scene_of(file.numbers)), text);
    EXPECT_THAT(file.notes, IsEmpty());
  }
}

TEST(FlatScene, HasANameUnitAndChoicesForEachNumber) {
  const std::vector<FlatField> fields = flat_fields();
  const FlatField& mass = fields[place_of("mass")];
  EXPECT_EQ(mass.table + " " + mass.unit + " " + mass.range, "scene kg > 0");
  EXPECT_THAT(mass.choices, IsEmpty());
  EXPECT_THAT(fields[place_of("centrifugal")].choices,
              ElementsAre("projected", "inward", "outward"));
  EXPECT_THAT(fields[place_of("contact_friction")].choices, ElementsAre("false", "true"));
  EXPECT_EQ(fields[place_of("restitution_upper")].range, "0..1");
  EXPECT_EQ(fields[place_of("seconds")].table, "window");
}

TEST(FlatScene, RefusesWhatIsNoMachine) {
  const std::vector<double> valid = numbers_of(Scene{});
  const auto with = [&](const std::string& key, double x) {
    std::vector<double> numbers = valid;
    numbers[place_of(key)] = x;
    return numbers;
  };
  EXPECT_NO_THROW(scene_of(valid));
  expect_refusals<InputError, std::vector<double>>(
      scene_of, {{with("mass", -1), "mass"},
                 {with("mass", quiet_nan), "mass"},
                 {with("rule", 2), "rule"},
                 {with("pull_rotates", quiet_nan), "pull_rotates"},
                 {with("seconds", quiet_nan), "window"},
                 {with("revolutions", 1), "window"}});
}

TEST(MachineFile, NotesOrRefusesWhatThePageCannotShow) {
  const auto read = [](const std::string& text) { return machine_file(text, "own.toml"); };
  const std::string text = write_scene(Scene{});
  EXPECT_THAT(read(std::regex_replace(text, std::regex("\nmass = .*"),
                                      "\nmass = { value = 2, plus_minus = 0.5 }"))
                  .notes,
              ElementsAre("scene.mass is uncertain in the file: taken at its value, 2"));
  Scene planar, profiled;
  planar.across.emplace();
  EXPECT_THAT(read(write_scene(planar)).notes, ElementsAre(HasSubstr("[across] is left out")));
  profiled.profile = {{0, 0}, {1, 6}};
  expect_refusals(
      read, {{write_scene(profiled), "own.toml: scene.omega is a profile"},
             {"[scene]\nmas = 1\n[window]\nseconds = 1\n", "own.toml: there is no key scene.mas"}});
}

TEST(CountThere, IsTheObjective) {
  RandomScenes random(8);
  int collisions = 0;
  for (int k = 0; k < 500; ++k) {
    Scene scene = random.next();
    if (k % 5 == 0) scene.rule = carrier_track::CountRule::peaks;
    const int count = count_there(scene);
    EXPECT_EQ(count, objective(scene, 0.0));
    collisions += count;
  }
  EXPECT_GT(collisions, 2000);
}

}  // namespace
}  // namespace ricochet::live
