#pragma once

#include "problems/carrier_track/motion/lanes.h"

namespace ricochet::carrier_track::inline models {

/// fly() with the instructions that every processor of the architecture has.
void fly_plain(Lanes& lanes);

/// The same with AVX2 and, if compiled by GCC, AVX-512. The bits are the same because no fused
/// operations are used.
void fly_avx2(Lanes& lanes);
void fly_avx512(Lanes& lanes);

}  // namespace ricochet::carrier_track::inline models
