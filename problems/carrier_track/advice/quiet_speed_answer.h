#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/sensitivity.h"
#include "src/report/json.h"

namespace ricochet::studies::advice {

/// How fast a machine may turn, and all that is said of it.
struct QuietSpeedAnswer {
  std::string name;
  carrier_track::Scene scene;
  carrier_track::QuietSpeed answer;
  std::vector<carrier_track::Sensitivity> sensitivities;  ///< empty where there is no divide
  double tolerance = 0;
  std::optional<carrier_track::ToleranceRange> range;
};

/// Computes the answer and all that is said of it; `tolerance` 0 draws no machines.
QuietSpeedAnswer answer_quiet_speed(const std::string& name, const carrier_track::Scene& scene,
                                    const carrier_track::QuietSpeedOptions& options,
                                    double tolerance);

/// A speed of a scan, a multiple of its step, without the last digits of its rounding.
std::optional<double> rounded(const std::optional<double>& speed);

/// "7.2 rad/s (68.8 rpm)"
std::string both_units(double omega);

/// The answer in a sentence or two.
std::string headline_of(const QuietSpeedAnswer& output);

/// Some lines for an engineer: the answer first.
std::string text_of(const QuietSpeedAnswer& output);

/// The steps of the staircase, a line each, the main one marked; a sentence where there is none.
std::string text_of_steps(const carrier_track::QuietSpeed& answer);

report::Json json_of(const QuietSpeedAnswer& output);

}  // namespace ricochet::studies::advice
