#include "problems/carrier_track/models/lanes.h"

#include "problems/carrier_track/models/lane_flight.h"

namespace ricochet::carrier_track::inline models {

void fly(Lanes& lanes) {
#ifdef RICOCHET_WIDE_LANES
  static const bool wide = __builtin_cpu_supports("avx2") != 0;
  if (wide) return fly_wide(lanes);
#endif
  fly_plain(lanes);
}

}  // namespace ricochet::carrier_track::inline models
