#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"
#include "src/report/text.h"
#include "tests/app/tool.h"

/// One machine: simulated, checked, advised, identified.
namespace ricochet::cli {
namespace {

using carrier_track::default_machine;
using carrier_track::read_scene;

TEST(Simulate, MarksWhatTheRuleCounts) {
  for (const auto& [rule, column] : {std::pair("impacts", "speed"), {"peaks", "maximum"}}) {
    const std::string command = filled("simulate --case C1 --set 'rule=\"{}\"'", rule);
    const Json count = json_of(command)["count"];
    const std::string shown = out_of(command);
    EXPECT_GT(count, 0);
    std::vector<bool> marks;  // of the lines of the table
    for (const std::string& line : lines_of(shown)) {
      if (line.ends_with("✓") || line.ends_with("✗")) marks.push_back(line.ends_with("✓"));
    }
    EXPECT_EQ(std::ranges::count(marks, true), count) << shown;
    EXPECT_TRUE(std::ranges::is_sorted(marks, std::greater())) << "not first:\n" << shown;
    EXPECT_THAT(shown, HasSubstr(column));
  }
}

/// Not by their names in /dev: a test that fails must not harm them.
TEST(Simulate, WritesThroughStandardOutputAndDevices) {
  if (const auto reason = missing({"/dev/full", "/proc/self/fd/1"}); !reason.empty()) {
    GTEST_SKIP() << reason;
  }
  const std::string command = "simulate --case C1 --csv /proc/self/fd/1";
  EXPECT_THAT(out_of(command),
              AllOf(StartsWith("time_s,"), HasSubstr("C1 at 3 rad/s: 5 collisions")));
  const Outcome full = call(command + " >/dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err, "ricochet: /proc/self/fd/1: cannot be written: No space left on device\n");
}

TEST(Scene, ThatCannotBeReachedIsRefused) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  fs::create_symlink("loop", here() / "loop");
  for (const std::string command :
       {"simulate --scene ", "scene --scene ", "report ", "list problems --scene ",
        "simulate --case C1 --csv ", "reproduce --quick --out ", "calibrate --quick --out ",
        "report " RICOCHET_SOURCE "/reports/reference/reproduction --out "}) {
    expect_refusal(command + "loop", "loop");
    expect_refusal(command + "loop/deeper", "loop");
  }
}

TEST(Machine, IsNewAsAFileThatCanBeReadWithoutAnythingFitted) {
  write("machine.toml", out_of("machine new"));
  const auto scene = read_scene(here() / "machine.toml");
  EXPECT_EQ(
      std::tuple(scene.mass, scene.centrifugal_mass_radius, scene.wall_upper, scene.start_velocity),
      std::tuple(1.2, 1.2 * 0.065, 0.8e-3, 0));
  // What is fitted to the paper's thresholds is no machine's.
  EXPECT_NE(scene.centrifugal_mass_radius, default_machine().centrifugal_mass_radius);
  EXPECT_NE(scene.wall_upper, default_machine().wall_upper);
  EXPECT_NE(scene.start_velocity, default_machine().start_velocity);
  EXPECT_NE(scene.counting_limit, default_machine().counting_limit);
}

TEST(Machine, IsCheckedFieldByField) {
  write("machine.toml", out_of("machine new"));
  EXPECT_THAT(out_of("machine check machine.toml"),
              AllOf(HasSubstr("mass = 1.2  # kg > 0: of the yarn carrier"),
                    HasSubstr("machine: every field is in its range, and nothing looks")));
}

TEST(Machine, IsAdvisedWithAPage) {
  write("loom.toml", out_of("scene --case C3"));
  const std::string advice = out_of("machine advise loom.toml --out page");
  EXPECT_THAT(advice, HasSubstr("loom: the fastest quiet speed is"));
  EXPECT_THAT(advice, StartsWith(out_of("threshold --scene loom.toml").substr(0, 60)));
  EXPECT_THAT(read("page/index.html"), HasSubstr("How fast may loom turn?"));
  EXPECT_THAT(read("page/regimes.csv"), HasSubstr("release"));
  out_of("machine advise --allow 3 loom.toml --out page");
  const Json steps = json_of("threshold --allow 3 --scene loom.toml")["steps"];
  ASSERT_FALSE(steps.empty());
  for (const auto& step : steps) {
    EXPECT_THAT(read("page/steps.csv"),
                HasSubstr(fmt::format("\n{:.6g},", step["omega"].get<double>())));
  }
}

const std::string knocks = RICOCHET_SOURCE "/examples/knocks/";
const std::string identify = "identify " + knocks + "knocks.csv --scene " + knocks +
                             "machine.toml --speed " + knocks + "speed.csv --marks " + knocks +
                             "marks.csv";

TEST(Identify, FindsTheMachineOfTheExample) {
  const Json json = json_of(identify + " --out fitted.toml --plot residuals.svg");
  const double truths[] = {0.5, 0.2, 0.7e-3};  // of examples/knocks/machine.toml
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& constant = json.at("constants").at(i);
    const double lower = constant.at("lower"), upper = constant.at("upper");
    EXPECT_LE(lower, truths[i]) << constant;
    EXPECT_GE(upper, truths[i]) << constant;
    EXPECT_LT(upper / lower, 1.2);
  }
  EXPECT_EQ(json.at("complete"), true);
  EXPECT_TRUE(json.at("contradictions").empty());
  EXPECT_GT(json.at("safe_speed").at("value"), 3);
  EXPECT_EQ(json.at("held_fixed").at(0), "mass");
  EXPECT_EQ(json.at("plate").at("marks"), true);
  EXPECT_EQ(read_scene(here() / "fitted.toml").friction, json.at("constants").at(1).at("value"));
  EXPECT_THAT(read("fitted.toml"), StartsWith("# Restitution, friction and clearance are fitted"));
  EXPECT_THAT(read("residuals.svg"),
              AllOf(StartsWith("<svg"), HasSubstr("Recorded minus predicted times")));
  EXPECT_THAT(out_of(identify),
              AllOf(HasSubstr("restitution"), HasSubstr("95 %"), HasSubstr("safe speed"),
                    HasSubstr("Record next"), HasSubstr("Held as in the file: mass")));
}

TEST(Identify, HasNoIntervalsWhereTheRecordContradictsWhatIsTakenForGranted) {
  const std::string wrong = identify + " --mark-angle 0.1 --mark-deviation 0";
  const Outcome words = call(wrong), as_json = call(wrong + " --format json");
  EXPECT_THAT((std::vector{words.exit_code, as_json.exit_code}), Each(1));
  EXPECT_THAT(words.out, AllOf(HasSubstr("The record contradicts the marks"),
                               HasSubstr("no interval"), Not(HasSubstr("95 %"))));
  const Json json = Json::parse(as_json.out);
  EXPECT_FALSE(json.at("contradictions").empty());
  for (const auto& constant : json.at("constants")) {
    EXPECT_TRUE(constant.at("lower").is_null() && constant.at("upper").is_null()) << constant;
  }
}

}  // namespace
}  // namespace ricochet::cli
