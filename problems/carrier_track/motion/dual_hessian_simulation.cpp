#include "problems/carrier_track/motion/dual_simulation.h"

namespace ricochet::carrier_track::inline models {

RICOCHET_DUAL_SIMULATION(, SecondSpeedDual)
RICOCHET_DUAL_SIMULATION(, SecondDesignDual)

}  // namespace ricochet::carrier_track::inline models
