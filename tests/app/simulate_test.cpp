#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"
#include "src/report/text.h"
#include "tests/app/tool.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

/// One machine: simulated, checked, advised, identified.
namespace ricochet::cli {
namespace {

using carrier_track::default_machine;
using carrier_track::read_scene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(Simulate, PrintsTheJsonOfTheContract) {
  const Json json = json_of("simulate --case C2 --omega 1.9");
  EXPECT_THAT(keys_of(json),
              ElementsAre("count", "surrogate", "certain", "complete", "reached", "margin", "graze",
                          "growth", "doubt", "impacts", "peaks", "end", "evaluations", "fidelity"));
  EXPECT_EQ(json["certain"], true);
  EXPECT_EQ(json["fidelity"], "impact");
  EXPECT_THAT(keys_of(json["impacts"][0]), ElementsAre("time", "wall", "speed"));
  EXPECT_THAT(json["impacts"][0]["wall"], testing::AnyOf("lower", "upper"));
  EXPECT_THAT(keys_of(json["peaks"][0]), ElementsAre("time", "position"));
  EXPECT_THAT(keys_of(json["end"]), ElementsAre("time", "position", "velocity"));
  std::size_t fast = 0;
  for (const auto& impact : json["impacts"]) {
    fast += impact["speed"] > default_machine().counting_limit ? 1 : 0;
  }
  EXPECT_GT(fast, 5U);
  EXPECT_EQ(json["count"], fast);
  EXPECT_GT(json["impacts"].size(), fast);
}

TEST(Simulate, TakesTheLevelOfTheModel) {
  const Json json = json_of("simulate --case C4 --fidelity compliant");
  EXPECT_EQ(json["fidelity"], "compliant");
  EXPECT_NE(json["count"], 6) << "a wall as soft as the default is another machine";
}

TEST(Simulate, MarksWhatTheRuleCounts) {
  const std::string scene = out_of("scene --case C1"), impacts = "rule = \"impacts\"";
  std::string by_peaks = scene;
  by_peaks.replace(scene.find(impacts), impacts.size(), "rule = \"peaks\"");
  for (const std::string& text : {scene, by_peaks}) {
    write("machine.toml", text);
    const Json count = json_of("simulate --scene machine.toml")["count"];
    const std::string shown = out_of("simulate --scene machine.toml");
    EXPECT_GT(count, 0);
    std::vector<bool> marks;  // of the lines of the table
    for (const std::string& line : lines_of(shown)) {
      if (line.ends_with("✓") || line.ends_with("✗")) marks.push_back(line.ends_with("✓"));
    }
    EXPECT_EQ(std::ranges::count(marks, true), count) << shown;
    EXPECT_TRUE(std::ranges::is_sorted(marks, std::greater())) << "not first:\n" << shown;
    EXPECT_THAT(shown, HasSubstr(text == scene ? "speed" : "maximum"));
  }
}

TEST(Simulate, WritesThePathWithoutARowTwice) {
  for (const std::string scene :
       {"--case C1", "--case C4 --omega 9", "--case C1 --fidelity compliant"}) {
    out_of("simulate {} --csv path.csv", scene);
    const std::string csv = read("path.csv");
    EXPECT_THAT(csv, StartsWith(filled("time_s,position_m,velocity_m_per_s\n0,{},",
                                       default_machine().start_position)));
    const std::vector<std::string> rows = lines_of(csv);
    EXPECT_EQ(std::set(rows.begin(), rows.end()).size(), rows.size()) << scene;
    EXPECT_GT(rows.size(), scene == "--case C1" ? 2000U : 1000U);
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
  std::filesystem::create_symlink("loop", here() / "loop");
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
    EXPECT_LE(constant.at("lower"), truths[i]) << constant;
    EXPECT_GE(constant.at("upper"), truths[i]) << constant;
    EXPECT_LT(constant.at("upper").get<double>() / constant.at("lower").get<double>(), 1.2);
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
  EXPECT_THAT((std::vector{words.exit_code, as_json.exit_code}), testing::Each(1));
  EXPECT_THAT(words.out, AllOf(HasSubstr("The record contradicts the marks"),
                               HasSubstr("no interval"), Not(HasSubstr("95 %"))));
  const Json json = Json::parse(as_json.out);
  EXPECT_FALSE(json.at("contradictions").empty());
  for (const auto& constant : json.at("constants")) {
    EXPECT_TRUE(constant.at("lower").is_null() && constant.at("upper").is_null()) << constant;
  }
}

TEST(Identify, SaysWhereItsTimeLimitEndedIt) {
  const Outcome outcome = call(identify + " --seconds 0.001");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the time limit of 0.001 s was reached"));
}

}  // namespace
}  // namespace ricochet::cli
