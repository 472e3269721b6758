#pragma once

#include <unistd.h>

#include "ricochet/solver.h"
#include "solvers/library_solvers.h"
#include "src/studies/calibration/results.h"
#include "src/studies/calibration/searches.h"
#include "src/studies/paper/interpretation.h"
#include "tests/support/test.h"

namespace ricochet::studies::calibration {

/// A search of so many evaluations by solvers that are cheap to start.
inline Search some_search(std::int64_t evaluations) {
  return {solver_named("nlopt-crs2"), ceres_least_squares(), solver_named("nlopt-sbplx"),
          evaluations};
}

/// The default interpretation with its start velocity and its counting limit free.
inline carrier_track::Parameterisation some_parameterisation() {
  using namespace carrier_track;
  const FittedInterpretation& fitted = default_interpretation();
  return {
      fitted.interpretation, {Unknown::start_velocity, Unknown::counting_limit}, fitted.constants};
}

/// The same, started far from its fit.
inline carrier_track::Parameterisation far_parameterisation() {
  carrier_track::Parameterisation far = some_parameterisation();
  far.constants[static_cast<std::size_t>(carrier_track::Unknown::counting_limit)] = 0.1;
  return far;
}

/// A file of this test that does not exist.
inline fs::path fresh_file() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      fs::path(testing::TempDir()) / (std::string("calibration_") + std::to_string(getpid()) +
                                      test->test_suite_name() + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder / "runs.sqlite";
}

/// What makes the runs of a test.
inline Provenance some_provenance() {
  return {{{"version", "a test"}}, {}};
}

/// Two interpretations and nothing that converges.
inline Plan tiny_plan() {
  Plan plan;
  plan.search = some_search(1);
  plan.finalist_evaluations = plan.pin_evaluations = 1;
  plan.left_out_evaluations = plan.profile_evaluations = 1;
  plan.fewest_constants = 8;
  plan.step = 0.2;
  plan.interpretations = {carrier_track::find_interpretation("projected-constant-revolutions"),
                          carrier_track::find_interpretation("inward-rotating-seconds")};
  plan.long_searches = LongSearches{{some_search(1).global}, {1, 2}, 4, 3, 3};
  return plan;
}

}  // namespace ricochet::studies::calibration
