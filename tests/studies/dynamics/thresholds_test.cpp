#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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
  const std::vector<Integrator> stand_ins = {{"silent", "0", "relative tolerance", silent},
                                             {"endless", "0", "step [s]", endless}};
  return study_thresholds({{"C1", "C2"}, 0.5, 9, {}, {1e-3, 1e-6}, {1e-4}}, stand_ins);
}

report::Json row_named(const report::Json& data, const std::string& name) {
  for (const report::Json& row : data["simulations"]) {
    if (row["simulation"] == name) return row;
  }
  throw std::out_of_range(name);
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
  const report::Json data = data_of(study_with_stand_ins());
  ASSERT_EQ(data["simulations"].size(), 5U);  // two levels, two tolerances, one step
  EXPECT_EQ(data["simulations"][0]["error"], 0.0);
  EXPECT_LT(row_named(data, "auto")["error"], 1e-6);
  const double first = data["cases"][0]["threshold"], second = data["cases"][1]["threshold"];
  const report::Json silent = row_named(data, "silent");  // quiet up to the fastest speed
  EXPECT_DOUBLE_EQ(silent["error"], 18 - std::min(first, second));
  EXPECT_DOUBLE_EQ(silent["error_least"], 18 - std::max(first, second));
  EXPECT_EQ(silent["control"], "tolerance 1e-3");
  EXPECT_FALSE(silent["within"].get<bool>());
  const report::Json endless = row_named(data, "endless");  // loud everywhere
  EXPECT_TRUE(endless["error"].is_null());
  EXPECT_EQ(endless["missing"], 2);
  EXPECT_EQ(endless["unfinished"], 72);  // 36 speeds of two cases
  EXPECT_EQ(endless["kind"], "fixed steps");
}

TEST(Thresholds, TellTheCheapestWithinTheTolerance) {
  const report::Json data = data_of(study_with_stand_ins());
  EXPECT_EQ(data["within"], 2);
  EXPECT_EQ(data["tried"], 5);
  for (const report::Json& row : data["simulations"]) {
    EXPECT_GT(row["seconds"], 0.0);
    EXPECT_LE(row["seconds_least"], row["seconds"]);
    EXPECT_GE(row["seconds_most"], row["seconds"]);
    if (row["within"].get<bool>()) {
      EXPECT_GE(row["seconds"], data["cheapest"]["seconds"]);
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::dynamics
