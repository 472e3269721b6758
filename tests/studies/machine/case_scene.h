#pragma once

#include "problems/carrier_track/suite/machine.h"

namespace ricochet::studies::advice {

/// A machine of the paper, as the suite reads it.
inline carrier_track::Scene case_scene(const char* id) {
  return scene_of(carrier_track::find_case(id), carrier_track::default_machine());
}

}  // namespace ricochet::studies::advice
