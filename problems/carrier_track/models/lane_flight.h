#pragma once

#include "problems/carrier_track/models/lanes.h"

namespace ricochet::carrier_track::inline models {

/// fly() with the instructions that every processor of the kind has.
void fly_plain(Lanes& lanes);

/// The same with those of AVX2, to the same bits: it has no fused operations.
void fly_wide(Lanes& lanes);

}  // namespace ricochet::carrier_track::inline models
