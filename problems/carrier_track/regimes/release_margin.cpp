#include "problems/carrier_track/regimes/release_margin.h"

#include <algorithm>
#include <limits>

#include "problems/carrier_track/flight/applied_forces.h"

namespace ricochet::carrier_track::inline regimes {

double release_margin(const Scene& scene, double position) {
  const Flight<double> held = AppliedForces<double>(scene).flight(position, 0, 0);
  double amplitude = 0;
  for (int i = 0; i < held.harmonics; ++i) amplitude += held.swing(i).amplitude;
  const double friction = scene.friction * scene.normal_force / scene.mass;
  double margin = -std::numeric_limits<double>::infinity();
  if (position < scene.wall_upper) margin = std::max(margin, amplitude + held.steady - friction);
  if (position > scene.wall_lower) margin = std::max(margin, amplitude - held.steady - friction);
  return margin;
}

}  // namespace ricochet::carrier_track::inline regimes
