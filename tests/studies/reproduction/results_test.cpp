#include <tbb/global_control.h>

#include "ricochet/machine.h"
#include "src/core/files.h"
#include "src/studies/reproduction/study.h"
#include "tests/studies/pages.h"
#include "tests/support/files.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Chart;
using report::Json;
using report::Results;

/// The whole study at the coarsest: a second or two.
const StudyPlan tiny_plan{{0.1, 1, 18.0}, 6.0, true};

Results computed() {
  const ScratchFolder folder;
  Results results = results_of(tiny_plan);
  add_solvers(true, folder.path() / "solvers.sqlite", {}, results);
  return results;
}

const Results& tiny_results() {
  static const Results results = computed();
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

TEST(ReproductionResults, CompareThePapersSolverWithOthers) {
  const Table& solvers = *tiny_results().table("solvers");
  for (const char* family : {"top-speed", "profile-count"}) {
    for (const char* solver : {"fireworks", "random-search"}) {
      const Table of_solver = where(solvers, "solver", value_of(solver));
      const Row row = row_of(of_solver, "family", family);
      EXPECT_GE(row.number("share"), row.number("lower"));
      EXPECT_LE(row.number("share"), row.number("upper"));
    }
  }
  EXPECT_EQ(*tiny_results().value("problems"), value_of(3));
  EXPECT_THAT(text_of(*tiny_results().value("libraries")), HasSubstr("NLopt"));
  EXPECT_NE(tiny_results().chart("runtimes"), nullptr);
}

/// Silence ends where the centrifugal force beats friction, a little later with a counting limit.
TEST(ReproductionResults, HaveTheBordersOfTheLongRun) {
  const Table& thresholds = *tiny_results().table("thresholds");
  ASSERT_EQ(thresholds.rows.size(), 12U);
  for (const char* id : {"C1", "C3"}) {
    const Scene scene = scene_of(find_case(id), default_interpretation().scene);
    const Row row = row_of(thresholds, "case", id);
    EXPECT_EQ(row.number("silent_up_to"), *quiet_up_to(scene, 0));
    EXPECT_EQ(row.number("quiet_up_to"), *quiet_up_to(scene, quiet_per_turn));
    const double release =
        std::sqrt(scene.friction * scene.normal_force / scene.centrifugal_mass_radius);
    EXPECT_GT(row.number("silent_up_to"), release);
    EXPECT_LT(row.number("silent_up_to"), 1.05 * release);
  }
  EXPECT_EQ(thresholds[0].number("paper_threshold"), 9);
  EXPECT_TRUE(is_missing(thresholds[10]["paper_threshold"])) << "C11";
  EXPECT_NEAR(thresholds[0].number("quiet_error"), thresholds[0].number("quiet_up_to") / 9 - 1,
              1e-12);
}

CaseStudy made_up(const char* id, std::optional<double> claim, std::optional<double> threshold) {
  CaseStudy c{};
  c.the_case.id = id;
  c.the_case.claim.threshold = claim;
  c.score.threshold = threshold;
  return c;
}

TEST(ReproductionResults, SayHowFarTheyAreFromThePaper) {
  std::vector<CaseStudy> cases = {made_up("C7", 2.0, 4.0), made_up("C8", 9.0, 9.0),
                                  made_up("C9", {}, 5.0)};
  cases[0].score.examples = {Example{1.5, false, 3, true}, Example{8, true, 4, false}};
  Results results;
  add_thresholds(cases, 5, results);
  EXPECT_EQ(*results.value("compared"), value_of(2)) << "the paper has none of C9";
  EXPECT_DOUBLE_EQ(*number_in(*results.value("error")), std::log(2.0) / std::sqrt(2.0));
  // Two of four samples have one error twice: the interval is from 0 to ln 2.
  EXPECT_THAT(text_of(*results.value("finding")), HasSubstr("49 % (95 % interval 0 to 69 %)"));
  EXPECT_THAT(
      text_of(*results.value("examples")),
      HasSubstr("Of the 2 speeds that the paper's figures show as quiet or loud, 1 come out "
                "on the paper's side. On the wrong side: C7 at 8 rad/s (4 collisions, shown "
                "loud)."));
  Results none;
  add_thresholds({made_up("C9", {}, 5.0)}, 5, none);
  EXPECT_THAT(text_of(*none.value("finding")), HasSubstr("none can be compared"));
}

TEST(ReproductionResults, SayWhereTheIncreaseIsAStep) {
  const Table& steps = *tiny_results().table("steps");
  ASSERT_EQ(steps.rows.size(), 12U);
  std::map<std::pair<double, std::string>, int> number;
  each_row(steps, [&](const Row& row) { ++number[{row.number("restitution"), row.text("rise")}]; });
  const Table& rises = *tiny_results().table("rises");
  ASSERT_EQ(rises.rows.size(), 2U);
  each_row(rises, [&](const Row& row) {
    EXPECT_EQ(row.number("cases"), 6);
    EXPECT_EQ(row.number("steps"), (number[{row.number("restitution"), "a step"}]));
    EXPECT_EQ(row.number("climbs"), (number[{row.number("restitution"), "a climb"}]));
  });
  EXPECT_GT(rises[0].number("steps"), 0);
  EXPECT_EQ(*tiny_results().value("claimed-counts"), value_of(10));
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
  const Scene scene = scene_of(find_case("C1"), default_interpretation().scene);
  const SpeedScan scan = scan_speeds(scene, tiny_plan.scan.step, tiny_plan.scan.highest);
  for (const report::Sample& sample : count.series[0].samples) {
    const auto k = static_cast<std::size_t>(std::lround(sample.position / scan.step)) - 1;
    EXPECT_EQ(sample.value, scan.counts.at(k)) << sample.position;
  }
  const Chart& quiet = *parts[0].results.chart("quiet");
  EXPECT_EQ(quiet.series[1].samples.size(),
            static_cast<std::size_t>(count_at(scene, find_case("C1").claim.figure->quiet)));
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

/// The page shows all that the data have.
TEST(ReproductionResults, AllHaveAReaderAndCanBeDrawn) {
  const std::string source = report::page_template("reproduction");
  const auto expect_reader = [&](const std::vector<std::string>& names) {
    EXPECT_TRUE(std::ranges::any_of(names, [&](const std::string& name) {
      return source.find("{{" + name + "}}") != std::string::npos ||
             source.find("{{" + name + ".") != std::string::npos;
    })) << names[0];
  };
  for (const Table& table : tiny_results().tables)
    expect_reader({"table " + table.name, table.name});
  for (const Chart& chart : tiny_results().charts) expect_reader({"chart " + chart.name});
  for (const report::Part& part : tiny_results().parts.at("cases"))
    for (const Chart& chart : part.results.charts) expect_reader({"chart " + chart.name});
  const auto files = study_page("reproduction", report::results_of(kept_data())).files;
  EXPECT_TRUE(files.contains("c4-count.svg")) << "README shows it";
  EXPECT_THAT(files.at("summary.md"), Not(HasSubstr("{{")));
}

TEST(ReproductionResults, AreTheSameOnAnyNumberOfThreads) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(json_of(computed()), json_of(tiny_results()));
}

TEST(ReproductionResults, AreEnoughToDrawThePageAgain) {
  const ScratchFolder folder;
  const auto first = folder.path() / "first", second = folder.path() / "second";
  const report::WrittenReport written = report::write_report(kept_data(), first);
  EXPECT_EQ(written.failures, std::vector<std::string>());
  EXPECT_EQ(report::redraw_report(first, second).epilogue, written.epilogue);
  EXPECT_THAT(written.epilogue, HasSubstr("root mean square in log speed"));
  const auto files_in = [](const fs::path& of) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(of))
      files[entry.path().filename().string()] = ricochet::text_of(entry.path());
    return files;
  };
  EXPECT_TRUE(files_in(first).contains("index.html"));
  EXPECT_TRUE(files_in(first).contains("thresholds.csv"));
  EXPECT_EQ(files_in(first), files_in(second));
}

}  // namespace
}  // namespace ricochet::studies::reproduction
