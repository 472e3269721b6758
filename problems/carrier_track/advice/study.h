#pragma once

#include <string>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "src/studies/study.h"

namespace ricochet::studies {

struct AdviceOptions {
  std::string name;  ///< of the machine
  carrier_track::Scene scene;
  carrier_track::QuietSpeedOptions quiet_speed;
  double tolerance = 0;  ///< share, of every constant
};

/// A page for whoever runs or builds a machine: how fast it may turn, what happens below and above
/// that, and what to change for more.
Study advice_study(const AdviceOptions& options);

}  // namespace ricochet::studies
