#pragma once

#include <string>
#include <vector>

#include "ricochet/recording.h"
#include "ricochet/threshold.h"
#include "src/report/chart.h"

namespace ricochet::studies::advice {

/// The counts over the speeds up to the fastest, sampled where they change.
std::vector<report::Sample> staircase_samples(const carrier_track::QuietSpeed& answer);

/// A speed [rad/s] to mark in a chart of a staircase, if any.
struct MarkedSpeed {
  std::optional<double> omega;
  std::string label;
};

/// The staircase with its steps marked; other marked speeds come first.
report::Chart staircase_chart(const carrier_track::QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked);

}  // namespace ricochet::studies::advice
