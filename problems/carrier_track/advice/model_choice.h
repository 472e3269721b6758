#pragma once

#include "ricochet/threshold.h"
#include "src/report/json.h"

namespace ricochet::studies::advice {

/// Whether a machine needs the planar model: whether it has a second direction, whether that
/// direction affects the first at the fastest quiet speed, and if so the results of both models.
report::Json model_choice(const carrier_track::Scene& scene,
                          const carrier_track::QuietSpeed& answer);

}  // namespace ricochet::studies::advice
