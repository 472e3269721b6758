#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline problems {

/// One combination of restitution, friction and disturbance that the paper studies.
struct Case {
  std::string id;
  double restitution;
  double friction;
  double disturbance;  ///< [N], amplitude of the cosine
  Claim claim;
};

/// C1..C12.
std::vector<Case> all_cases();

/// Throws InputError, which lists the known ids, for an unknown id.
Case find_case(const std::string& id);

/// The scene of a case: a machine with the case's restitution, friction and disturbance.
Scene scene_of(const Case& a_case, const Scene& machine);

}  // namespace ricochet::carrier_track::inline problems
