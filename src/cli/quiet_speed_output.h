#pragma once

#include <string>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/sensitivity.h"
#include "src/cli/format.h"

namespace ricochet::cli {

/// What is asked of a machine of one's own, beside the speed range.
struct QuietSpeedOutput {
  std::string name;
  carrier_track::Scene scene;
  carrier_track::QuietSpeed answer;
  std::vector<carrier_track::Sensitivity> sensitivities;  ///< empty where there is no divide
  double tolerance = 0;
  std::optional<carrier_track::ToleranceRange> range;
};

/// Computes the answer and all that is said of it; `tolerance` 0 draws no machines.
QuietSpeedOutput ask_quiet_speed(const std::string& name, const carrier_track::Scene& scene,
                                 const carrier_track::QuietSpeedOptions& options, double tolerance);

/// "7.2 rad/s (68.8 rpm)"
std::string both_units(double omega);

/// Some lines for an engineer: the answer first.
std::string text_of(const QuietSpeedOutput& output);

/// The steps of the staircase, a line each, the main one marked; a sentence where there is none.
std::string text_of_steps(const carrier_track::QuietSpeed& answer);

Json json_of(const QuietSpeedOutput& output);

}  // namespace ricochet::cli
