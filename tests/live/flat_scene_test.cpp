#include "src/live/flat_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/error.h"

namespace ricochet::live {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::size_t place_of(const std::string& key) {
  const std::vector<FlatField> fields = flat_fields();
  const auto at = std::ranges::find(fields, key, &FlatField::key);
  EXPECT_NE(at, fields.end()) << key;
  return static_cast<std::size_t>(at - fields.begin());
}

TEST(FlatScene, ComesBackAsTheSameFile) {
  carrier_track::RandomScenes random(5);
  for (int k = 0; k < 200; ++k) {
    Scene scene = random.next();
    if (k % 3 == 0) scene.contact_speed = 0.25;
    const std::vector<double> numbers = numbers_of(scene);
    EXPECT_EQ(numbers.size(), flat_fields().size());
    EXPECT_EQ(write_scene(scene_of(numbers)), write_scene(scene));
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
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(scene_of(valid));
  EXPECT_THROW(scene_of(with("mass", -1)), InputError);
  EXPECT_THROW(scene_of(with("mass", none)), InputError);
  EXPECT_THROW(scene_of(with("rule", 2)), InputError);
  EXPECT_THROW(scene_of(with("pull_rotates", none)), InputError);
  EXPECT_THROW(scene_of(with("seconds", none)), InputError) << "no window";
  EXPECT_THROW(scene_of(with("revolutions", 1)), InputError) << "two windows";
}

}  // namespace
}  // namespace ricochet::live
