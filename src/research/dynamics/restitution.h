#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene/contact_law.h"
#include "src/report/json.h"

/// What restitution a contact law returns for the one that its damping was made from.
namespace ricochet::studies::dynamics {

struct ReturnedRestitution {
  double asked;     ///< in (0, 1)
  double returned;  ///< in [0, 1]
};

/// One law, by its closed relation and by simulation.
struct LawStudy {
  std::string name;  ///< as in a scene's file
  carrier_track::ContactLaw law;
  std::vector<ReturnedRestitution> exact;     ///< finely spaced
  std::vector<ReturnedRestitution> measured;  ///< of simulated impacts
};

/// The asked value whose returned one is furthest from it, by the closed relation.
ReturnedRestitution worst_of(const LawStudy& study);

/// Largest difference between a measured point and the closed relation at it.
double largest_measurement_error(const LawStudy& study);

/// By the closed relation (returned_restitution, kelvin_voigt_restitution), for asked in (0, 1).
double closed_return(carrier_track::ContactLaw law, double asked);

/// The ratio of the speeds after and before a simulated impact on a compliant wall, at 1 m/s, that
/// no other force disturbs.
double measured_return(carrier_track::ContactLaw law, double asked);

/// Every law, asked for 0.02, 0.03, ..., 0.98, and measured at every `stride`-th of them.
std::vector<LawStudy> study_laws(std::size_t stride);

/// Asked for against returned, a line a law.
report::Json data_of(const std::vector<LawStudy>& laws);

}  // namespace ricochet::studies::dynamics
