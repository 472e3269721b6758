#pragma once

#include "problems/carrier_track/counting/quiet_speed.h"
#include "src/report/json.h"

namespace ricochet::studies::advice {

/// Whether the planar model is needed for a machine: whether it has a second direction, whether
/// that acts on the first at the fastest quiet speed, and if so what either model says.
report::Json model_choice(const carrier_track::Scene& scene,
                          const carrier_track::QuietSpeed& answer);

}  // namespace ricochet::studies::advice
