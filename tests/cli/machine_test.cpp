#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "problems/carrier_track/problems/default_machine.h"
#include "ricochet/scene.h"
#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Machine, IsNewAsAFileThatCanBeRead) {
  const auto file = write(fresh_folder(), "machine.toml", call("machine new").out);
  const auto scene = carrier_track::read_scene(file);
  EXPECT_EQ(scene.restitution_lower, 0.1);
  EXPECT_THAT(call("machine new").out, HasSubstr("ricochet machine advise FILE"));
}

TEST(Machine, IsCheckedFieldByField) {
  const auto folder = fresh_folder();
  const auto file = write(folder, "machine.toml", call("machine new").out).string();
  const Outcome good = call("machine check " + file);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_THAT(good.out, HasSubstr(fmt::format("mass = {}  # kg > 0: of the yarn carrier",
                                              carrier_track::default_machine().mass)));
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
  const auto json = nlohmann::json::parse(call("threshold --format json --scene " + file).out);
  ASSERT_FALSE(json["steps"].empty());
  for (const auto& step : json["steps"]) {
    EXPECT_THAT(read(page / "steps.csv"),
                HasSubstr(fmt::format("\n{:.6g},", step["omega"].get<double>())));
  }
  expect_refusal("machine advise " + file + " --fastest 0", "--fastest");
}

}  // namespace
}  // namespace ricochet::cli
