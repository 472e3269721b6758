#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene/contact_law.h"
#include "src/report/json.h"

/// Restitution that a contact law returns, compared with the value its damping was computed from.
namespace ricochet::studies::dynamics {

struct ReturnedRestitution {
  double asked;     ///< in (0, 1)
  double returned;  ///< in [0, 1]
};
RICOCHET_WRITTEN_AS_JSON(ReturnedRestitution, asked, returned);

/// One law, by its closed relation and by simulation.
struct LawStudy {
  std::string name;  ///< as in a scene's file
  carrier_track::ContactLaw law;
  std::vector<ReturnedRestitution> exact;     ///< finely spaced
  std::vector<ReturnedRestitution> measured;  ///< of simulated impacts
};

/// The requested value with the largest difference from the returned one, by the closed relation.
ReturnedRestitution worst_of(const LawStudy& study);

/// Largest difference between a measured point and the closed relation at it.
double largest_measurement_error(const LawStudy& study);

/// Returned restitution by the closed relation (returned_restitution, kelvin_voigt_restitution),
/// for asked in (0, 1).
double closed_return(carrier_track::ContactLaw law, double asked);

/// Ratio of the speeds after and before a simulated impact on a compliant wall, at 1 m/s, without
/// any other force.
double measured_return(carrier_track::ContactLaw law, double asked);

/// Every law, for 0.02, 0.03, ..., 0.98, and by simulation for every `stride`-th of them.
std::vector<LawStudy> study_laws(std::size_t stride);

/// Requested against returned restitution, a line for each law.
report::Json data_of(const std::vector<LawStudy>& laws);

}  // namespace ricochet::studies::dynamics
