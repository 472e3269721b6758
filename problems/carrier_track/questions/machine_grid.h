#pragma once

#include <string>
#include <vector>

#include "problems/family.h"

namespace ricochet::carrier_track::inline questions {

/// The families of questions asked of machines around a case of the paper, one for every
/// combination of restitution (of both walls), friction and disturbance [N]; a list that is empty
/// leaves the case's own. "C1-r0.5-f0.2-d1" is one with these three. Quiet limits are found as
/// `ricochet threshold` does; best values are not known: see with_scanned_best. Throws InputError
/// for an unknown case or a machine that is none.
std::vector<Family> grid_families(const std::string& around, const std::vector<double>& restitution,
                                  const std::vector<double>& friction,
                                  const std::vector<double>& disturbance);

}  // namespace ricochet::carrier_track::inline questions
