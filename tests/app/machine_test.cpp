#include "problems/carrier_track/suite/machine.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ricochet/scene.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Machine, IsNewAsAFileThatCanBeRead) {
  const auto file = write(fresh_folder(), "machine.toml", call("machine new").out);
  const auto scene = carrier_track::read_scene(file);
  EXPECT_EQ(scene.mass, 1.2);
  EXPECT_EQ(scene.centrifugal_mass_radius, 1.2 * 0.065);
  EXPECT_EQ(scene.wall_upper, 0.8e-3);
  EXPECT_EQ(scene.start_velocity, 0);
  EXPECT_THAT(call("machine new").out, HasSubstr("ricochet machine advise FILE"));
}

/// What is fitted to the paper's thresholds is no machine's.
TEST(Machine, IsNewWithoutAnythingFitted) {
  const auto file = write(fresh_folder(), "machine.toml", call("machine new").out);
  const auto scene = carrier_track::read_scene(file);
  const auto& fitted = carrier_track::default_machine();
  EXPECT_NE(scene.centrifugal_mass_radius, fitted.centrifugal_mass_radius);
  EXPECT_NE(scene.wall_upper, fitted.wall_upper);
  EXPECT_NE(scene.start_velocity, fitted.start_velocity);
  EXPECT_NE(scene.counting_limit, fitted.counting_limit);
}

TEST(Machine, IsCheckedFieldByField) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("machine new").out).string();
  const Outcome good = call("machine check " + file);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_THAT(good.out, HasSubstr("mass = 1.2  # kg > 0: of the yarn carrier"));
  EXPECT_THAT(good.out, HasSubstr("machine: every field is in its range, and nothing looks"));
  const auto odd = write(folder, "odd.toml",
                         "[scene]\nmass=1200\nwall_lower=0\nwall_upper=0.8\n"
                         "restitution=0.5\nstart_position=0.4\n[window]\nrevolutions=2\n")
                       .string();
  const Outcome doubtful = call("machine check " + odd);
  EXPECT_EQ(doubtful.exit_code, 0);
  EXPECT_THAT(doubtful.out, HasSubstr("Is it meant? scene.mass = 1200 kg"));
  EXPECT_THAT(doubtful.out, HasSubstr("friction = 0.0"));  // the default is shown
  expect_refusal("machine check " + (folder / "none.toml").string(), "none.toml");
  expect_refusal("machine", "ubcommand");
}

TEST(Machine, IsCheckedWithSettingsAndUncertainties) {
  const auto file = write(fresh_folder(), "machine.toml", call("machine new").out).string();
  const std::string out =
      call("machine check " + file +
           " --set 'mass={value = \"900 g\", plus_minus = \"50 g\"}' --set restitution_upper=0.25")
          .out;
  EXPECT_THAT(out, HasSubstr("mass = 0.9  #"));
  EXPECT_THAT(out, HasSubstr("restitution_upper = 0.25  #"));
  EXPECT_THAT(out, HasSubstr("# scene.mass = 0.9 is uncertain by +-0.05 kg.\n"));
  expect_refusal("machine check " + file + " --set mass=0",
                 file + " with --set mass=0: scene.mass = 0: must be a finite number > 0 [kg]");
  expect_refusal("machine advise " + file + " --set mas=1", "--set mas=1: there is no key mas; ");
}

TEST(Machine, IsAdvisedWithAPage) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "loom.toml", call("scene --case C3").out).string();
  const auto page = folder / "page";
  const Outcome outcome = call("machine advise " + file + " --out " + page.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("loom: the fastest quiet speed is"));
  EXPECT_THAT(outcome.out,
              testing::StartsWith(call("threshold --scene " + file).out.substr(0, 60)));
  EXPECT_THAT(read(page / "index.html"), HasSubstr("How fast may loom turn?"));
  EXPECT_THAT(read(page / "regimes.csv"), HasSubstr("release"));
  ASSERT_EQ(call("machine advise --allow 3 " + file + " --out " + page.string()).exit_code, 0);
  const auto json =
      nlohmann::json::parse(call("threshold --allow 3 --format json --scene " + file).out);
  ASSERT_FALSE(json["steps"].empty());
  for (const auto& step : json["steps"]) {
    EXPECT_THAT(read(page / "steps.csv"),
                HasSubstr(fmt::format("\n{:.6g},", step["omega"].get<double>())));
  }
  expect_refusal("machine advise " + file + " --fastest 0", "--fastest");
}

}  // namespace
}  // namespace ricochet::cli
