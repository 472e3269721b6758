#include "src/studies/machine/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"

namespace ricochet::studies {
namespace {

using namespace carrier_track;
using report::Results;
using testing::HasSubstr;

/// As they are computed, with the six digits of data.json.
Results results_for(const Scene& scene, const QuietSpeedOptions& options) {
  return report::results_in(advice_study({"mine", scene, options, 0}).compute(false));
}

Scene case_scene(const char* id) {
  return scene_of(find_case(id), default_machine());
}

/// What is asked of C1 by default: it takes some seconds.
const Results& results_of_c1() {
  static const Results results = results_for(case_scene("C1"), {});
  return results;
}

constexpr double six_digits = 2e-6;

TEST(AdviceStudy, DrawsTheStaircaseWhereItIs) {
  const Scene scene = case_scene("C1");
  const Results results = results_for(scene, {Limit{Measure::collisions, 6}, 1e-3, 18});
  const auto& samples = results.chart("staircase")->series.at(0).samples;
  ASSERT_GT(samples.size(), 3U);
  for (const report::Sample& sample : samples) {
    EXPECT_LE(sample.position, 18);
    EXPECT_EQ(sample.value, count_at(scene, sample.position));
  }
  const auto& energies = results.chart("energy")->series.at(0).samples;
  ASSERT_EQ(energies.size(), 300U);
  for (const report::Sample& sample : energies) {
    const double energy = 1e3 * measured(at_speed(scene, sample.position), Measure::energy);
    EXPECT_NEAR(*sample.value, energy, six_digits * energy);
  }
  EXPECT_FALSE(results.table("steps")->rows.empty());
  EXPECT_EQ(results.table("around")->rows.size(), 3U);
  EXPECT_TRUE(results.table("regimes")->rows.empty());
}

TEST(AdviceStudy, DrawsTheLongRunUnlessTheWindowIsLimited) {
  const Results& results = results_of_c1();
  const auto regimes = regimes_of(case_scene("C1"));
  EXPECT_EQ(results.chart("staircase")->series.at(0).samples.size(), regimes.size() + 1);
  const Table& table = *results.table("regimes");
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table[2].text("collisions"), "2");
  const auto near = [](double expected) {
    return testing::DoubleNear(expected, six_digits * expected);
  };
  EXPECT_THAT(table[2].number("to"), near(regimes[3].to));
  EXPECT_THAT(table[2].number("energy_per_turn"), near(regimes[3].last.energy_per_turn));
  EXPECT_THAT(table[2].number("fastest_impact"), near(regimes[3].last.fastest_impact));
  const auto& energies = results.chart("energy")->series.at(0).samples;
  ASSERT_EQ(energies.size(), 2 * regimes.size());
  EXPECT_THAT(*energies[7].value, near(1e3 * regimes[3].last.energy_per_turn));
}

TEST(AdviceStudy, ShowsThePathsBelowAndAbove) {
  const auto& paths = results_of_c1().parts.at("paths");
  ASSERT_EQ(paths.size(), 2U);
  std::vector<double> counts;
  for (const report::Part& path : paths) {
    counts.push_back(number_in(*path.results.value("count")).value());
    EXPECT_EQ(path.results.chart("path")->series.at(1).samples.size(), counts.back()) << path.id;
  }
  EXPECT_LT(counts[0], counts[1]);
}

TEST(AdviceStudy, MarksTheMaximaWhereTheseCount) {
  Scene scene = case_scene("C1");
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.9 * scene.wall_upper;
  scene.peak_low = 0.1 * scene.wall_upper;
  const Results results = results_for(scene, {Limit{Measure::collisions, 6}, 1e-2, 12});
  const auto& paths = results.parts.at("paths");
  ASSERT_EQ(paths.size(), 2U);
  for (const report::Part& path : paths) {
    EXPECT_EQ(*path.results.value("what-counts"), Value("maximum that counts"));
  }
}

/// The constant whose change by one per cent moves the speed most, by computing it again.
TEST(AdviceStudy, SaysFirstWhatMovesTheSpeedMost) {
  const Scene scene = case_scene("C1");
  const Results& results = results_of_c1();
  const Table& changes = *results.table("changes");
  ASSERT_GE(changes.rows.size(), 4U);
  for (std::size_t i = 0; i + 1 < changes.rows.size(); ++i) {
    EXPECT_GE(std::abs(changes[i].number("percent")), std::abs(changes[i + 1].number("percent")));
  }
  const auto limit =
      changes.find([](const Row& row) { return row.text("constant") == "counting_limit"; });
  ASSERT_TRUE(limit);
  Scene louder = scene, quieter = scene;
  louder.counting_limit *= 1.01;
  quieter.counting_limit /= 1.01;
  const double moved =
      std::log(*quiet_up_to(louder, 2) / *quiet_up_to(quieter, 2)) / (2 * std::log(1.01));
  EXPECT_NEAR(limit->number("percent"), moved, 0.005);
}

TEST(AdviceStudy, FillsItsPageWhateverTheAnswer) {
  const auto page = report::page_source(report::page_template("advice"));
  Scene slip = case_scene("C3");
  slip.wall_upper = 0.8;
  slip.window = Seconds{1};
  const Results doubtful = results_for(slip, {std::nullopt, 1e-2, 5});
  for (Results results :
       {results_of_c1(), results_for(case_scene("C3"), {Limit{Measure::collisions, 99}, 1e-2, 4}),
        results_for(case_scene("C3"), {Limit{Measure::collisions, 0}, 1e-2, 4}), doubtful}) {
    for (const char* name : {"version", "compiler", "threads", "seconds", "date"})
      results.set(std::string("made.") + name, "1");
    const auto [files, failures] = page_files(page, results);
    EXPECT_TRUE(failures.empty());
    EXPECT_THAT(files.at("summary.md"), testing::StartsWith("# How fast may mine turn?\n\nmine: "));
    EXPECT_THAT(terminal_text(page, results), testing::StartsWith("mine: "));
  }
  EXPECT_THAT(doubtful.table("doubts")->rows.at(0).at(0),
              testing::VariantWith<std::string>(HasSubstr("0.8 m: walls so far apart")));
}

}  // namespace
}  // namespace ricochet::studies
