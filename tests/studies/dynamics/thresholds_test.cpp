#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/studies/dynamics/fidelity.h"

namespace ricochet::studies::dynamics {
namespace {

/// A study of C1 and C2 with a method that always counts `count`, and one that never ends.
ThresholdStudy study_with_stand_ins() {
  using carrier_track::Integrator;
  using carrier_track::Outcome;
  using carrier_track::Scene;
  const auto silent = [](const Scene&, double) {
    Outcome outcome;
    outcome.finished = true;
    return outcome;
  };
  const auto endless = [](const Scene&, double) { return Outcome{}; };
  const std::vector<Integrator> stand_ins = {
      {"silent", "0", "", "", carrier_track::by_tolerance, {}, true, silent},
      {"endless", "0", "", "", carrier_track::by_step, {}, true, endless}};
  return study_thresholds({{"C1", "C2"}, 0.5, 9, {}, {1e-3, 1e-6}, {1e-4}}, stand_ins);
}

const Table& table_with_stand_ins() {
  static const report::Results results = [] {
    report::Results made;
    add_to(made, study_with_stand_ins());
    return made;
  }();
  return *results.table("thresholds");
}

Row row_named(const std::string& name) {
  return table_with_stand_ins()
      .find([&](const Row& row) { return row.text("simulation") == name; })
      .value();
}

TEST(Thresholds, OfHardWallsAreThoseThatTheProblemsOfTopSpeedKnow) {
  const ThresholdStudy study =
      study_thresholds({{"C1", "C2", "C3", "C4"}, 0.25, 18, {}, {}, {}}, {});
  std::size_t known = 0;
  for (const carrier_track::Machine& machine : carrier_track::all_machines()) {
    const Problem problem = carrier_track::top_speed_problem(machine);
    for (std::size_t c = 0; c < study.plan.cases.size(); ++c) {
      if (problem.name != "top-speed-" + study.plan.cases[c]) continue;
      const auto& speed = study.simulations.front().cases[c].speed;
      ASSERT_TRUE(speed && problem.best_known);
      EXPECT_NEAR(*speed, -*problem.best_known, 1e-6) << problem.name;
      ++known;
    }
  }
  EXPECT_EQ(known, 4U);
  EXPECT_EQ(found_within, carrier_track::speed_tolerance);
}

TEST(Thresholds, AreThoseOfTheSimulation) {
  ASSERT_EQ(table_with_stand_ins().rows.size(), 5U);  // two levels, two tolerances, one step
  EXPECT_EQ(row_named("event-driven").number("error"), 0.0);
  EXPECT_LT(row_named("auto").number("error"), 1e-6);
  const ThresholdStudy study = study_with_stand_ins();
  const auto& right = study.simulations.front().cases;
  const Row silent = row_named("silent");  // quiet up to the fastest speed
  EXPECT_DOUBLE_EQ(silent.number("error"), 18 - std::min(*right[0].speed, *right[1].speed));
  EXPECT_DOUBLE_EQ(silent.number("error_least"), 18 - std::max(*right[0].speed, *right[1].speed));
  EXPECT_EQ(silent.text("control").substr(0, 10), "tolerance ");
  EXPECT_FALSE(silent.is("within"));
  const Row endless = row_named("endless");  // loud everywhere
  EXPECT_FALSE(endless.number_if("error"));
  EXPECT_EQ(endless.number("unfinished"), 72);  // 36 speeds of two cases
}

TEST(Thresholds, TellTheCheapestWithinTheToleranceFirst) {
  const Table& table = table_with_stand_ins();
  EXPECT_TRUE(table[1].is("within"));
  EXPECT_FALSE(table[2].is("within"));
  EXPECT_LE(table[0].number("seconds"), table[1].number("seconds"));
  each_row(table, [](const Row& row) {
    EXPECT_GT(row.number("seconds"), 0.0);
    EXPECT_LE(row.number("seconds_least"), row.number("seconds"));
    EXPECT_GE(row.number("seconds_most"), row.number("seconds"));
  });
}

}  // namespace
}  // namespace ricochet::studies::dynamics
