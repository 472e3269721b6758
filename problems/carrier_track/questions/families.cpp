#include "problems/carrier_track/questions/families.h"

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/calibration.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/design.h"
#include "problems/carrier_track/questions/profile.h"
#include "problems/carrier_track/questions/robust.h"
#include "problems/carrier_track/questions/top_speed.h"

namespace ricochet::carrier_track::inline questions {

std::vector<Family> families_of(const std::vector<Machine>& machines) {
  return {
      count_family(machines),
      top_speed_family(machines),
      profile_count_family(machines),
      profile_wear_family(machines),
      design_count_family(machines),
      robust_family(machines, RiskMeasure::mean),
      robust_family(machines, RiskMeasure::worst),
      robust_family(machines, RiskMeasure::cvar),
  };
}

std::vector<Family> case_families() {
  std::vector<Family> families = families_of(all_machines());
  families.push_back(calibration_family(default_reading()));
  return families;
}

}  // namespace ricochet::carrier_track::inline questions
