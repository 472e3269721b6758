#pragma once

#include "src/studies/calibration/results.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {

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
