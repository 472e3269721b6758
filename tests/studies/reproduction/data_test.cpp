#include "src/studies/reproduction/data.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "ricochet/machine.h"
#include "src/studies/suite/suite.h"
#include "tests/studies/reproduction/drawn_results.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

const Json& tiny_data() {
  static const Json data = [] {
    const auto folder =
        std::filesystem::path(testing::TempDir()) / fmt::format("ricochet_tiny_{}", getpid());
    std::filesystem::create_directories(folder);
    Json all =
        kept_data(results_of(tiny_plan(), whole_catalogue(), {folder / "comparison.sqlite", {}}));
    std::filesystem::remove_all(folder);
    return all;
  }();
  return data;
}

/// As the page shows it: "–" for null.
std::string shown(const Json& number, const char* formulation) {
  return number.is_null() ? "–" : fmt::format(fmt::runtime(formulation), number.get<double>());
}

std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(stream), {}};
  }
  return files;
}

/// The case of a row; a star marks those whose quiet count is found by another rule.
const Json& case_of(const std::vector<report::Cell>& row) {
  std::string id = row[0].text;
  if (id.ends_with('*')) id.pop_back();
  return tiny_data()["cases"].at(id);
}

TEST(ReproductionData, ShowsItsNumbersInTheTables) {
  const report::Page page = page_of(tiny_data());
  const auto& thresholds = section_of(page, "thresholds").tables.at(0).rows;
  ASSERT_EQ(thresholds.size(), 12U);
  for (const auto& row : thresholds) {
    const Json& c = case_of(row);
    EXPECT_EQ(row[4].text, shown(c["paper_threshold"], "{}"));
    EXPECT_EQ(row[5].text, shown(c["threshold"], "{:.3f}"));
    EXPECT_EQ(row[9].text, shown(c["quiet_count"], "{}"));
  }
  EXPECT_EQ(thresholds[0][4].text, "9");
  EXPECT_EQ(thresholds[9][0].text, "C10");
  EXPECT_EQ(thresholds[10][0].text, "C11*");
  EXPECT_EQ(thresholds[10][4].text, "–");
  const auto& long_run = section_of(page, "long-run").tables.at(0).rows;
  ASSERT_EQ(long_run.size(), 12U);
  for (const auto& row : long_run) {
    const Json& c = case_of(row);
    EXPECT_EQ(row[4].text, shown(c["silent_up_to"], "{:.3f}"));
    EXPECT_EQ(row[5].text, shown(c["quiet_up_to"], "{:.3f}"));
  }
  const auto& examples = section_of(page, "thresholds").tables.at(2).rows;
  ASSERT_EQ(examples.size(), 10U);
  for (std::size_t k = 0; k < examples.size(); ++k) {
    const Json& loud = tiny_data()["thresholds"]["examples"][k]["loud"];
    EXPECT_EQ(examples[k][5].text, shown(loud["count"], "{}"));
    EXPECT_EQ(examples[k][5].state, loud["right"] ? report::State::good : report::State::bad);
  }
  const auto& solvers = section_of(page, "solvers").tables.at(0).rows;
  const Json& ratings = tiny_data()["comparison"]["groups"][0]["budgets"][1]["ratings"];
  ASSERT_GE(solvers.size(), 15U);
  ASSERT_EQ(solvers.size(), ratings.size());
  for (std::size_t k = 0; k < solvers.size(); ++k) {
    EXPECT_EQ(solvers[k][0].text, ratings[k]["solver"]);
    EXPECT_EQ(solvers[k][2].text, shown(ratings[k]["rank"], "{:.1f}"));
  }
}

/// Silence ends where the centrifugal force beats friction, a little later with a counting limit.
TEST(ReproductionData, HasTheBordersOfTheLongRun) {
  for (const char* id : {"C1", "C3"}) {
    const Scene scene = scene_of(find_case(id), carrier_track::default_interpretation().scene);
    const Json& c = tiny_data()["cases"][id];
    EXPECT_EQ(c["silent_up_to"], *quiet_up_to(scene, 0));
    EXPECT_EQ(c["quiet_up_to"], *quiet_up_to(scene, quiet_per_turn));
    const double release =
        std::sqrt(scene.friction * scene.normal_force / scene.centrifugal_mass_radius);
    EXPECT_GT(c["silent_up_to"], release);
    EXPECT_LT(c["silent_up_to"], 1.05 * release);
  }
}

TEST(ReproductionData, GivesTheFrontPageTheFastestQuietSpeedsOfTheLongRun) {
  const Json& cases = tiny_data()["cases"];
  const Json& speeds = tiny_data()["speeds"];
  ASSERT_EQ(speeds["machines"].size(), 4U);
  for (const Json& machine : speeds["machines"]) {
    double least = 1e9, most = 0;
    for (const Json& c : cases) {
      if (c["restitution"] != machine["restitution"] || c["friction"] != machine["friction"]) {
        continue;
      }
      least = std::min(least, c["quiet_up_to"].get<double>());
      most = std::max(most, c["quiet_up_to"].get<double>());
    }
    EXPECT_EQ(machine["speed"]["least"], least);
    EXPECT_EQ(machine["speed"]["most"], most);
  }
  EXPECT_EQ(speeds["example"]["speed"], cases["C3"]["quiet_up_to"]);
}

TEST(ReproductionData, ShowsTheStepsBesideThePapersRule) {
  const report::Page page = page_of(tiny_data());
  const auto& rows = section_of(page, "steps").tables.at(0).rows;
  ASSERT_EQ(rows.size(), 12U);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    EXPECT_EQ(row[1].text, shown(tiny_data()["cases"][row[0].text]["paper_threshold"], "{}"));
    EXPECT_EQ(row[2].text, shown(tiny_data()["cases"][row[0].text]["threshold"], "{:.3f}"));
    const Json& found = tiny_data()["steps"]["cases"][k];
    std::string steps;
    for (const Json& step : found["steps"]) {
      steps +=
          fmt::format("{}{:.2f} ({} to {})", steps.empty() ? "" : "; ", step["omega"].get<double>(),
                      step["below"].get<int>(), step["above"].get<int>());
    }
    EXPECT_EQ(row[3].text, steps.empty() ? "none" : steps);
    EXPECT_EQ(row[4].text, shown(found["main"], "{:.2f}"));
  }
  EXPECT_NE(rows[0][3].text, "none");
  EXPECT_EQ(rows[1][3].text, "none");
}

TEST(ReproductionData, SaysWhichThresholdsAreSteps) {
  const report::Page page = page_of(tiny_data());
  const auto& rows = section_of(page, "sharpness").tables.at(0).rows;
  ASSERT_EQ(rows.size(), 12U);
  int steps = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    const Json& found = tiny_data()["sharpness"]["cases"][k];
    EXPECT_EQ(row[2].text, shown(tiny_data()["cases"][row[0].text]["threshold"], "{:.3f}"));
    EXPECT_EQ(row[3].text, shown(found["before"], "{}"));
    EXPECT_EQ(row[4].text, shown(found["after"], "{}"));
    EXPECT_EQ(row[9].text == "a step", found["is_step"].is_null() ? false : bool(found["is_step"]));
    steps += row[9].text == "a step" ? 1 : 0;
    EXPECT_EQ(row[9].text == "a step", row[9].state == report::State::good) << row[0].text;
  }
  const Json& rises = tiny_data()["sharpness"]["rises"];
  EXPECT_EQ(rises[0]["steps"].get<int>() + rises[1]["steps"].get<int>(), steps);
  EXPECT_EQ(rises[0]["all"], 6);
  EXPECT_EQ(rises[1]["all"], 6);
  EXPECT_GT(steps, 0);
}

TEST(ReproductionData, ShowsEveryCurveFigureMapAndContradiction) {
  const report::Page page = page_of(tiny_data());
  EXPECT_EQ(section_of(page, "counts").figures.size(), 12U);
  EXPECT_EQ(section_of(page, "paths").figures.size(),
            12U + 4 + tiny_data()["paths"]["frames"].size());
  EXPECT_EQ(section_of(page, "crossing").figures.size(), 2U);
  EXPECT_EQ(section_of(page, "conclusions").figures.size(), 3U);
  EXPECT_EQ(section_of(page, "contradictions").tables.at(0).rows.size(), 11U);
  std::set<std::string> names;
  for (const report::Section& section : page.sections) {
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(names.insert(figure.chart.name).second) << figure.chart.name;
    }
  }
}

TEST(ReproductionData, AreEnoughToDrawThePageAgain) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "ricochet_reproduction_redrawn";
  std::filesystem::remove_all(folder);
  const report::WrittenReport written = report::write_report(tiny_data(), folder / "first");
  EXPECT_EQ(written.failures, std::vector<std::string>());
  EXPECT_EQ(report::redraw_report(folder / "first", folder / "second").epilogue, written.epilogue);
  const auto first = files_of(folder / "first");
  EXPECT_TRUE(first.contains("index.html"));
  EXPECT_TRUE(first.contains("cases.csv"));
  EXPECT_EQ(first, files_of(folder / "second"));
  std::filesystem::remove_all(folder);
}

TEST(ReproductionData, MapsTheRegimesOfBothFrictions) {
  const Json& maps = tiny_data()["regime_maps"]["maps"];
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0]["cases"][0]["id"], "C1");
  EXPECT_EQ(maps[0]["cases"][1]["id"], "C2");
  EXPECT_NEAR(maps[0]["cases"][1]["quiet"].get<double>(), 2.0075, 1e-3);
  EXPECT_EQ(maps[1]["friction"], 0.4);
  const report::Page page = page_of(tiny_data());
  const auto& figures = section_of(page, "regimes").figures;
  ASSERT_EQ(figures.size(), 2U);
  for (const report::Figure& figure : figures) {
    EXPECT_EQ(figure.failure, "");
    EXPECT_NO_THROW(report::check(figure.chart));
    EXPECT_EQ(figure.chart.areas.front().label, "silent: no impact is fast enough to count");
  }
}

}  // namespace
}  // namespace ricochet::studies::reproduction
