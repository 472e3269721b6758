#pragma once

#include "ricochet/scene.h"

namespace ricochet::live {

/// The collision count of a valid scene at its own constant speed, the same as objective(): without
/// what only other rules and levels of the model need, where it can.
int count_there(const carrier_track::Scene& scene);

}  // namespace ricochet::live
