#pragma once

#include "problems/carrier_track/models/lanes.h"

namespace ricochet::carrier_track::inline models {

/// fly() with the instructions that every processor of the kind has.
void fly_plain(Lanes& lanes);

/// The same with those of AVX2 and, compiled by GCC, of AVX-512, to the same bits: without fused
/// operations.
void fly_avx2(Lanes& lanes);
void fly_avx512(Lanes& lanes);

}  // namespace ricochet::carrier_track::inline models
