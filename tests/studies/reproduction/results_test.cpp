#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "ricochet/machine.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/studies/reproduction/sections.h"
#include "src/studies/suite/suite.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Chart;
using report::Json;
using report::Results;
using testing::HasSubstr;
using testing::Not;

const Findings& tiny_findings() {
  static const Findings findings = [] {
    const auto folder =
        std::filesystem::path(testing::TempDir()) / fmt::format("ricochet_tiny_{}", getpid());
    std::filesystem::create_directories(folder);
    Findings found =
        findings_of(tiny_plan(), whole_catalogue(), {folder / "comparison.sqlite", {}});
    std::filesystem::remove_all(folder);
    return found;
  }();
  return findings;
}

const Results& tiny_results() {
  static const Results results = results_of(tiny_findings());
  return results;
}

/// The data as they are read back from the file, with what every study adds.
Json kept_data() {
  Json data = {{"report", "reproduction"},
               {"made",
                {{"version", "1.2.3"},
                 {"compiler", "none"},
                 {"threads", 2},
                 {"seconds", 1.5},
                 {"date", "2026-01-02"}}}};
  data.update(Json::parse(json_of(tiny_results()).dump()));
  return data;
}

report::PageSource page() {
  return report::page_source(report::page_template("reproduction"));
}

std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(stream), {}};
  }
  return files;
}

/// Silence ends where the centrifugal force beats friction, a little later with a counting limit.
TEST(ReproductionResults, HaveTheBordersOfTheLongRun) {
  const Table& thresholds = *tiny_results().table("thresholds");
  ASSERT_EQ(thresholds.rows.size(), 12U);
  for (const char* id : {"C1", "C3"}) {
    const Scene scene = scene_of(find_case(id), default_interpretation().scene);
    const auto row = thresholds.find([&](const Row& r) { return r.text("case") == id; });
    ASSERT_TRUE(row);
    EXPECT_EQ(row->number("silent_up_to"), *quiet_up_to(scene, 0));
    EXPECT_EQ(row->number("quiet_up_to"), *quiet_up_to(scene, quiet_per_turn));
    const double release =
        std::sqrt(scene.friction * scene.normal_force / scene.centrifugal_mass_radius);
    EXPECT_GT(row->number("silent_up_to"), release);
    EXPECT_LT(row->number("silent_up_to"), 1.05 * release);
  }
  EXPECT_EQ(thresholds[0].number("paper_threshold"), 9);
  EXPECT_TRUE(is_missing(thresholds[10]["paper_threshold"])) << "C11";
  EXPECT_NEAR(thresholds[0].number("quiet_error"), thresholds[0].number("quiet_up_to") / 9 - 1,
              1e-12);
}

TEST(ReproductionResults, SayWhichExampleSpeedsAreOnTheWrongSide) {
  EXPECT_THAT(text_of(*tiny_results().value("examples")), HasSubstr("Of the 20 speeds"));
  Findings findings;
  findings.cases.resize(1);
  findings.cases[0].the_case.id = "C7";
  findings.cases[0].score.examples = {Example{1.5, false, 3, true}, Example{8, true, 4, false}};
  Results results;
  add_thresholds(findings, results);
  EXPECT_THAT(
      text_of(*results.value("examples")),
      HasSubstr("Of the 2 speeds that the paper's figures show as quiet or loud, 1 come out "
                "on the paper's side. On the wrong side: C7 at 8 rad/s (4 collisions, shown "
                "loud)."));
}

TEST(ReproductionResults, HaveAllStepsOfEveryStaircase) {
  const Table& steps = *tiny_results().table("steps");
  ASSERT_EQ(steps.rows.size(), 12U);
  int sharp = 0;
  for (std::size_t k = 0; k < steps.rows.size(); ++k) {
    const CaseStudy& c = tiny_findings().cases[k];
    const std::string& all = steps[k].text("steps");
    EXPECT_EQ(steps[k].text("case"), c.the_case.id);
    EXPECT_EQ(all == "none", c.staircase.steps.empty());
    for (const Step& step : c.staircase.steps)
      EXPECT_THAT(all,
                  HasSubstr(fmt::format("{:.2f} ({} to {})", step.omega, step.below, step.above)));
    EXPECT_EQ(steps[k].number_if("main").has_value(), !c.staircase.steps.empty());
    sharp += steps[k].text("rise") == "a step";
  }
  EXPECT_GT(sharp, 0);
  EXPECT_THAT(text_of(*tiny_results().value("rises")), HasSubstr(" of 6 cases"));
  EXPECT_THAT(text_of(*tiny_results().value("staircases")), HasSubstr("thresholds"));
}

TEST(ReproductionResults, ToldStepsAreThoseOfTheTable) {
  int without = 0;
  const Table& steps = *tiny_results().table("steps");
  each_row(steps, [&](const Row& row) { without += row.text("steps") == "none"; });
  EXPECT_THAT(text_of(*tiny_results().value("staircases")),
              HasSubstr(fmt::format(" {} cases have no step at all", without)));
}

TEST(ReproductionResults, RankTheBestOfEachFamilyBesideThePapersSolver) {
  const Table& solvers = *tiny_results().table("solvers");
  std::map<std::string, double> last;
  std::set<std::string> paper, drawn;
  each_row(solvers, [&](const Row& row) {
    const std::string family = row.text("family");
    if (const auto rank = row.number_if("rank")) {
      EXPECT_GE(*rank, last[family]);
      last[family] = *rank;
    }
    if (row.text("solver") == "fireworks") paper.insert(family);
    if (row.text("solver") == "random-search") drawn.insert(family);
    EXPECT_LE(row.number("lower"), row.number("share"));
    EXPECT_GE(row.number("upper"), row.number("share"));
  });
  EXPECT_EQ(paper.size(), 2U);
  EXPECT_EQ(drawn.size(), 2U);
  const Chart& runtimes = *tiny_results().chart("runtimes");
  EXPECT_EQ(std::ranges::count_if(runtimes.series, &report::Series::dark), 1) << "the paper's";
  for (const report::Series& series : runtimes.series) {
    EXPECT_EQ(series.samples.front().value, 0);
    EXPECT_TRUE(std::ranges::is_sorted(series.samples, {}, &report::Sample::value));
  }
}

TEST(ReproductionResults, ShowWhatMovesTheSpeed) {
  const Table& exponents = *tiny_results().table("exponents");
  double largest = 10;
  std::set<std::string> fitted;
  each_row(exponents, [&](const Row& row) {
    double most = 0;
    for (const char* id : {"C1", "C2", "C3", "C4"})
      most = std::max(most, std::abs(row.number_if(id).value_or(0)));
    EXPECT_LE(most, largest) << "the strongest first";
    largest = most;
    if (row.text("known") == "fitted") fitted.insert(row.text("constant"));
  });
  EXPECT_EQ(fitted,
            (std::set<std::string>{"centrifugal mass radius", "clearance", "counting limit"}));
  const std::string moves = text_of(*tiny_results().value("moves"));
  EXPECT_THAT(moves, HasSubstr("fitted to the paper's thresholds and not measured"));
  Scene scene = scene_of(find_case("C1"), default_interpretation().scene);
  std::string speeds;
  for (const double limit : {1e-3, 3e-3, default_interpretation().scene.counting_limit, 10e-3}) {
    scene.counting_limit = limit;
    const double speed = *quiet_up_to(scene, quiet_per_turn);
    speeds += fmt::format("{}{:.2f}", speeds.empty() ? "" : limit == 10e-3 ? " and " : ", ", speed);
  }
  EXPECT_THAT(moves, HasSubstr("C1 is quiet up to " + speeds + " rad/s"));
  const Chart& chart = *tiny_results().chart("threshold-over-counting-limit");
  EXPECT_EQ(chart.series.size(), 4U);
  EXPECT_EQ(chart.lines.at(0).label, "fitted");
}

TEST(ReproductionResults, HaveAPictureOfEveryFigure) {
  const auto& parts = tiny_results().parts.at("cases");
  ASSERT_EQ(parts.size(), 12U);
  std::map<std::string, std::size_t> charts;
  for (const report::Part& part : parts) charts[part.id] = part.results.charts.size();
  EXPECT_EQ(charts["c1"], 5U) << "counts, both speeds of its figure, both sides of the threshold";
  EXPECT_EQ(charts["c5"], 3U);
  EXPECT_EQ(charts["c11"], 1U) << "the paper has no figure";
  const Chart& count = *parts[0].results.chart("count");
  EXPECT_EQ(count.lines.size(), 3U);
  const SpeedScan& scan = tiny_findings().cases[0].scan;
  for (const report::Sample& sample : count.series[0].samples) {
    const auto k = static_cast<std::size_t>(std::lround(sample.position / scan.step)) - 1;
    EXPECT_EQ(sample.value, scan.counts.at(k)) << sample.position;
  }
  const Chart& quiet = *parts[0].results.chart("quiet");
  EXPECT_EQ(quiet.series[1].samples.size(),
            static_cast<std::size_t>(tiny_findings().cases[0].paths->quiet.count));
  EXPECT_THAT(quiet.title, HasSubstr("5 impacts count, 2 of the start"));
}

TEST(ReproductionResults, MapTheRegimesOfBothFrictions) {
  for (const auto& [name, title] :
       {std::pair("regimes-0-1",
                  "Friction 0.1, no disturbance: in the long run C1 is quiet up to "
                  "8.08, C2 is quiet up to 2.01 rad/s"),
        std::pair("regimes-0-4",
                  "Friction 0.4, no disturbance: in the long run C3 is quiet up to "
                  "12.15, C4 is quiet up to 3.54 rad/s")}) {
    const Chart* chart = tiny_results().chart(name);
    ASSERT_NE(chart, nullptr);
    EXPECT_EQ(chart->title, title);
    EXPECT_EQ(chart->areas.front().label, "silent: no impact is fast enough to count");
  }
}

/// Whoever looks at the page sees all that the data have.
TEST(ReproductionResults, AllHaveAReaderAndCanBeDrawn) {
  const std::string source = report::page_template("reproduction");
  const auto has_reader = [&](const std::string& name) {
    return source.find("{{" + name + "}}") != std::string::npos ||
           source.find("{{" + name + ".") != std::string::npos;
  };
  for (const Table& table : tiny_results().tables)
    EXPECT_TRUE(has_reader("table " + table.name) || has_reader(table.name)) << table.name;
  for (const Chart& chart : tiny_results().charts)
    EXPECT_TRUE(has_reader("chart " + chart.name)) << chart.name;
  for (const report::Part& part : tiny_results().parts.at("cases")) {
    for (const Chart& chart : part.results.charts)
      EXPECT_TRUE(has_reader("chart " + chart.name)) << part.id << " " << chart.name;
  }
  const auto [files, failures] = page_files(page(), report::results_of(kept_data()));
  EXPECT_THAT(failures, testing::IsEmpty());
  EXPECT_TRUE(files.contains("c4-count.svg")) << "README shows it";
  EXPECT_THAT(files.at("summary.md"), Not(HasSubstr("{{")));
}

TEST(ReproductionResults, AreEnoughToDrawThePageAgain) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "ricochet_reproduction_redrawn";
  std::filesystem::remove_all(folder);
  const report::WrittenReport written = report::write_report(kept_data(), folder / "first");
  EXPECT_EQ(written.failures, std::vector<std::string>());
  EXPECT_EQ(report::redraw_report(folder / "first", folder / "second").epilogue, written.epilogue);
  EXPECT_THAT(written.epilogue, HasSubstr("root mean square in log speed"));
  const auto first = files_of(folder / "first");
  EXPECT_TRUE(first.contains("index.html"));
  EXPECT_TRUE(first.contains("thresholds.csv"));
  EXPECT_EQ(first, files_of(folder / "second"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
