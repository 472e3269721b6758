#include <gtest/gtest.h>

#include "ricochet/solvers.h"
#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/research/limits/results.h"
#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

/// The shortest study there is.
Plan tiny_plan() {
  Plan plan = quick_plan();
  plan.first_constants = plan.order.size();
  plan.population = 8;
  plan.generations = 1;
  plan.long_evaluations = plan.asked_evaluations = plan.near_evaluations = 4;
  plan.solvers = {solver_named("nlopt-crs2")};
  plan.near = solver_named("nlopt-sbplx");
  plan.exclusion = {plan.near, 2, {1, 2}};
  plan.grid_steps = 2;
  plan.symmetry_draws = 2;
  plan.step = 1;
  return plan;
}

report::Json tiny_data() {
  FitStore store(no_file_yet());
  report::Json data = data_of(limits(tiny_plan(), store));
  data["made"] = {{"version", "1"}, {"threads", 2}, {"seconds", 1.5}};
  return data;
}

TEST(LimitsData, FillTheirPage) {
  const report::Json data = tiny_data();
  const report::DrawnPage drawn = report::drawn(report::page_template("limits"), data);
  EXPECT_EQ(drawn.page.sections.front().id, "together");
  EXPECT_TRUE(drawn.page.intro.front().starts_with(
      "The paper's ten thresholds cannot be had within 2.6 %"));
  EXPECT_TRUE(drawn.tables.contains("exclusion.csv"));
}

TEST(LimitsData, AreTheSameEveryTimeAndGoOnFromTheStore) {
  const auto file = no_file_yet();
  FitStore store(file);
  const report::Json one = data_of(limits(tiny_plan(), store));
  const auto written = std::filesystem::last_write_time(file);
  FitStore again(file);
  EXPECT_TRUE(data_of(limits(tiny_plan(), again)).dump() == one.dump());
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
}

TEST(LimitsData, TellWhatTheBoundsAndSearchesSay) {
  FitStore store(no_file_yet());
  const Results results = limits(tiny_plan(), store);
  const report::Json data = data_of(results);
  EXPECT_EQ(data["ordered"]["largest"], results.ordered.largest);
  EXPECT_EQ(data["ordered"]["rows"].size(), 10U);
  EXPECT_EQ(data["exclusion"]["rows"].size(), 32U);
  EXPECT_EQ(data["relief_map"]["rows"].size(), 3U);
  for (const auto& row : data["relief_map"]["rows"]) EXPECT_EQ(row["reliefs"].size(), 10U);
  EXPECT_EQ(data["asked"].size(), asked_groups().size());
  ASSERT_EQ(data["long_searches"].size(), 2U + results.plan.others.size());
  EXPECT_EQ(data["main_error"]["lowest"], results.long_searches[0].lowest());
  for (const LongSearches& one : results.long_searches) {
    for (const auto* ends : {&one.found, &one.from_fronts}) {
      for (const GoalFound& end : *ends) EXPECT_LE(one.lowest(), end.whole.loss);
    }
    EXPECT_EQ(one.from_fronts.size(), one.interpretation == results.plan.main ? 2U : 0U);
  }
  double least = results.long_searches[0].best.fine.threshold_error;
  for (const Judged& point : results.points) least = std::min(least, point.fine.threshold_error);
  EXPECT_LE(data["best_error"]["threshold_error"], least);
  EXPECT_EQ(data["grid"]["points"], 8);
  EXPECT_EQ(data["front_seeds"].size(), 1U);
  EXPECT_EQ(data["front_seeds"][0]["shares"].size(), 2U);
}

}  // namespace
}  // namespace ricochet::studies::limits
