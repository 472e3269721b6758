#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"

/// Commands whose result is a report: those of the studies, and those that draw reports again.
namespace ricochet::cli {
namespace {

const std::string reference = RICOCHET_SOURCE "/reports/reference";

TEST(ReportCommand, FailsWhereAChartCannotBeDrawnAndDrawsAllOthers) {
  Json data = report::data_in(read(reference + "/surrogate/data.json"));
  data["charts"]["speed-gap"]["series"][0]["samples"][0][1] = 1e200;
  write("mine/data.json", report::json_text(data));
  const Outcome outcome = call("report mine");
  EXPECT_EQ(outcome.exit_code, 2) << "the data are the input";
  EXPECT_EQ(outcome.err,
            "ricochet: mine/data.json: chart speed-gap could not be drawn: "
            "series \"C1\", sample 0: 1e+200 is beyond 1e100\n");
  EXPECT_FALSE(exists("mine/speed-gap.svg"));
  const std::string trend = read("mine/validity-trend.svg");
  EXPECT_THAT(trend, HasSubstr("<svg"));
  EXPECT_THAT(read("mine/index.html"),
              AllOf(HasSubstr("1e+200 is beyond 1e100"), HasSubstr(trend)));
  EXPECT_THAT(read("mine/summary.md"), Not(HasSubstr("(speed-gap.svg)")));
}

/// Keeps the reference's report as report/data.json, with a change of its text.
void keep_changed(const std::string& report, const std::string& from, const std::string& to) {
  std::string text = read(reference + "/" + report + "/data.json");
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from;
  write(report + "/data.json", text.replace(place, from.size(), to));
}

TEST(ReportCommand, RefusesDamagedDataWithFileAndKey) {
  const std::string name = "\"report\":\"surrogate\"";
  for (const auto& [from, to, complaint] : std::vector<std::array<std::string, 3>>{
           {"{", "", "parse error"},
           {name, "\"report\":7", "(/report)"},
           {name, "\"report\":\"none\"", "no such report"},
           {"\"quiet-speeds\":", "\"quiet-speed\":", "quiet-speeds"},
           {name, name + ",\"pages\":7", "(/pages)"},
           {name, name + ",\"deep\":" + std::string(100'000, '['), "nested deeper than 100"},
           // It writes only below its folder.
           {name, name + ",\"pages\":[\"../other\"]", "pages: \"../other\" is no folder's name"}}) {
    keep_changed("surrogate", from, to);
    expect_refusal("report surrogate", complaint);
    expect_refusal("report surrogate", "surrogate/data.json: ");
  }
}

TEST(ReportCommand, NamesEveryDamagedReportOfAFolderAndDrawsTheOthers) {
  keep_changed("calibration", "\"agreement\":", "\"agrement\":");
  keep_changed("surrogate", "{", "");
  keep_changed("verification", "{", "{");
  for (const std::string out : {"out", "."}) {
    const Outcome outcome = call("report . --out {}", out);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err,
                testing::MatchesRegex("ricochet: ./calibration/data.json: .*agreement.*; "
                                      "./surrogate/data.json: must be the data of a report: .*\n"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("verification")));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_TRUE(exists(out + "/verification/index.html"));
    EXPECT_THAT(read(out + "/index.html"), HasSubstr("No count called certain is wrong."));
    EXPECT_EQ(read(out + "/surrogate/data.json"), read("surrogate/data.json"));
  }
}

void expect_to_stand_alone(const std::string& html, const std::string& question) {
  EXPECT_THAT(html, AllOf(HasSubstr(question), Not(HasSubstr("<script src")),
                          Not(HasSubstr("<link")), Not(HasSubstr("<img"))));
}

TEST(Reproduce, WritesAReportThatStandsAlone) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  EXPECT_THAT(out_of("reproduce --quick --out new/report"), HasSubstr("new/report/index.html"));
  expect_to_stand_alone(read("new/report/index.html"), "How far off are the computed speeds?");
  EXPECT_THAT(read("new/report/summary.md"), AllOf(HasSubstr("| C12 |"), HasSubstr("fireworks")));
  EXPECT_TRUE(exists("new/report/c1-count.svg"));
  EXPECT_TRUE(exists("new/report/c1-loud.svg"));
}

TEST(Surrogate, WritesAReportThatStandsAlone) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  EXPECT_THAT(out_of("surrogate --quick --out new/report"), HasSubstr("new/report/index.html"));
  expect_to_stand_alone(read("new/report/index.html"), "Where does the gradient mean something?");
  EXPECT_TRUE(exists("new/report/speed-gap.svg"));
  out_of("report new/report --out again");
  for (const std::string file : {"index.html", "summary.md", "bias.csv", "data.json"}) {
    EXPECT_EQ(read("again/" + file), read("new/report/" + file)) << file;
  }
}

TEST(Verify, FindsNoCertainCountWrong) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const auto results = report::results_in(json_of("verify --scenes 200"));
  const Table& scenes = *results.table("scenes");
  const Row all = scenes[scenes.rows.size() - 1];
  EXPECT_EQ(all.text("scenes"), "all");
  EXPECT_EQ(all.number("number"), 200);
  EXPECT_EQ(all.number("wrong_certain"), 0);
  EXPECT_GT(all.number("certain"), 0.8);  // three of the thirteen kinds are open by design
  EXPECT_GT(all.number("matched"), 700);
  EXPECT_LT(all.number("time_error"), 1e-5);
  EXPECT_TRUE(is_missing(*results.value("wrong")));
  const Table& speeds = *results.table("quiet-speeds");
  ASSERT_EQ(speeds.rows.size(), 12U);
  each_row(speeds, [](const Row& quiet) {
    EXPECT_GT(quiet.number("speeds"), 100);
    EXPECT_GT(quiet.number("compared"), 10);
    EXPECT_GT(quiet.number("certain"), 0.99);
    EXPECT_EQ(quiet.number("wrong_certain"), 0);
  });
}

TEST(Verify, ShowsOneSceneWithBothListsOfImpacts) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const Json json = json_of("verify --scene-index 1");
  EXPECT_EQ(json["hostility"], "graze");
  EXPECT_EQ(json["count"], json["oracle_count"]);
  EXPECT_FALSE(json["impacts"].empty());
  EXPECT_FALSE(json["oracle_impacts"].empty());
  // Its text is a scene that simulate takes.
  const std::string shown = out_of("verify --scene-index 1");
  EXPECT_THAT(shown, HasSubstr("impacts of the oracle"));
  write("scene.toml", shown);
  EXPECT_EQ(json_of("simulate --scene scene.toml")["count"], json["count"]);
}

TEST(Manifest, TellsOfTheCoresThatItMayUse) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  // The last of the cores that the shell may use.
  const Outcome outcome = call_in_shell(
      "taskset -c $(taskset -cp $$ | grep -o '[0-9]*$') ricochet surrogate --quick --out report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read("report/data.json"), HasSubstr("\"threads\":1,"));
}

TEST(Simulators, ComparesAToolOfOnesOwn) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  // It loses every impact.
  write("quiet.sh", "while read -r line; do echo '{\"impacts\":[],\"seconds\":1}'; done\n");
  const std::string command =
      "simulators --tools none --quick --scenes 11 --levels usual --out out "
      "--tool 'quiet=sh quiet.sh'";
  const Json json = json_of(command);
  EXPECT_EQ(json["values"]["scenes"], 11);
  EXPECT_EQ(json["values"]["lost"], 0);
  const Json& tools = json["tables"]["simulators"];
  EXPECT_EQ(tools["columns"][2]["name"], "missed");
  EXPECT_EQ(tools["rows"][0][0], "ricochet");
  EXPECT_EQ(std::ranges::count_if(
                tools["rows"], [](const Json& row) { return row[0] == "quiet" && row[2] == 1000; }),
            1);
  const std::string html = read("out/index.html");
  expect_to_stand_alone(html, "What restitution does a contact law");
  EXPECT_THAT(html, HasSubstr("quiet"));
  EXPECT_THAT(read("out/scenes.jsonl"), HasSubstr("\"impacts\""));
  // Three scenes that break it, of different kinds; each is a machine.
  std::vector<Json> scenes;
  for (const std::string& line : lines_of(read("out/smallest/quiet.jsonl")))
    scenes.push_back(Json::parse(line));
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_NE(scenes[0]["kind"], scenes[1]["kind"]);
  write("machine.toml", scenes[0]["machine"]);
  EXPECT_EQ(json_of("simulate --scene machine.toml")["count"], 1);
  EXPECT_THAT(out_of(command), HasSubstr("quiet")) << "again, from what is kept";
}

TEST(Simulators, ListsItsTools) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  const Json tools = json_of("simulators --list-tools --tools ode --out .");
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0]["tool"], "ode");
}

TEST(Bench, PrintsGoogleBenchmarksOwnJson) {
  if (const auto reason = missing({RICOCHET_PROGRAM "-bench"}); !reason.empty()) {
    GTEST_SKIP() << reason;
  }
  const Json json = json_of(
      "bench --benchmark_min_time=0.001 "
      "'--benchmark_filter=-memory|complete-scan|regimes/C([5-9]|1.)'");
  EXPECT_TRUE(json.contains("context"));
  EXPECT_FALSE(json["benchmarks"].empty());
  expect_refusal("bench --fast", "--fast");
  expect_refusal("bench --format xml", "--format");
}

}  // namespace
}  // namespace ricochet::cli
