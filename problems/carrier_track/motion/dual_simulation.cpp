#include "problems/carrier_track/motion/dual_simulation.h"

namespace ricochet::carrier_track::inline models {

RICOCHET_DUAL_SIMULATION(, SpeedDual)
RICOCHET_DUAL_SIMULATION(, DesignDual)

}  // namespace ricochet::carrier_track::inline models
