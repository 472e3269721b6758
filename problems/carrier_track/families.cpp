#include "problems/carrier_track/families.h"

#include "problems/carrier_track/calibration.h"
#include "problems/carrier_track/count.h"
#include "problems/carrier_track/design.h"
#include "problems/carrier_track/fitted_reading.h"
#include "problems/carrier_track/profile.h"
#include "problems/carrier_track/robust.h"
#include "problems/carrier_track/top_speed.h"

namespace ricochet::carrier_track {

std::vector<Family> families_of(const std::vector<Machine>& machines) {
  return {
      count_family(machines),
      surrogate_family(machines),
      top_speed_family(machines),
      top_speed_surrogate_family(machines),
      profile_count_family(machines),
      profile_family(machines),
      profile_wear_family(machines),
      design_count_family(machines),
      design_family(machines),
      robust_family(machines, Risk::mean),
      robust_surrogate_family(machines, Risk::mean),
      robust_family(machines, Risk::worst),
      robust_surrogate_family(machines, Risk::worst),
      robust_family(machines, Risk::cvar),
      robust_surrogate_family(machines, Risk::cvar),
  };
}

std::vector<Family> case_families() {
  std::vector<Family> families = families_of(all_machines());
  families.push_back(calibration_family(default_reading()));
  return families;
}

}  // namespace ricochet::carrier_track
