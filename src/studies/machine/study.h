#pragma once

#include <string>

#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/machine.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

struct AdviceOptions {
  std::string name;  ///< of the machine
  carrier_track::Scene scene;
  carrier_track::QuietSpeedOptions quiet_speed;
  double tolerance = 0;                  ///< relative, of every constant
  carrier_track::SceneFile source = {};  ///< where the scene comes from
};

/// A page for users and makers of a machine: how fast it may turn, what happens below and above
/// that speed, and what to change for a higher one.
Study advice_study(const AdviceOptions& options);

}  // namespace ricochet::studies
