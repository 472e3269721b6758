#pragma once

#include <span>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"

/// A limit that a user sets on the collisions, the energy or the impact speed of a machine.
namespace ricochet::carrier_track::inline counting {

/// The quantity of a window that a limit refers to.
enum class Measure {
  collisions,           ///< in the window
  collisions_per_turn,  ///< of the driver plate
  energy,               ///< [J], dissipated by the walls in the window, see wear.h
  impact_speed          ///< [m/s], speed of the fastest impact
};

struct Limit {
  Measure measure = Measure::collisions;
  double at_most = 0;
};

/// The measure of a valid scene at the speed of the scene.
double measured(const Scene& scene, Measure measure);

/// The same at several speeds [rad/s]; neighbours should be similar.
std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds);

/// The split of the speeds step, 2 step, ..., highest [rad/s] into those that keep the limit and
/// those that exceed it, with the fewest misclassified. first_loud is the lowest speed that exceeds
/// it; it does not depend on the end of the range.
Split split_by(const Scene& scene, const Limit& limit, double step, double highest);

}  // namespace ricochet::carrier_track::inline counting
