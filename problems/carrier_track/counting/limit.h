#pragma once

#include <span>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"

/// What a machine may do at the most, where somebody says so.
namespace ricochet::carrier_track::inline counting {

/// What a window may be judged by.
enum class Measure {
  collisions,           ///< in the window
  collisions_per_turn,  ///< of the driver plate
  energy,               ///< [J], that the walls take in the window, see wear.h
  impact_speed          ///< [m/s], of the fastest impact
};

struct Limit {
  Measure measure = Measure::collisions;
  double at_most = 0;
};

/// The measure of a valid scene at its own speed.
double measured(const Scene& scene, Measure measure);

/// The same at several speeds [rad/s], of which neighbours should be similar.
std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds);

/// Where the limit is kept on the speeds step, 2 step, ..., highest [rad/s]: first_loud is the
/// lowest that breaks it, whatever the end of the range; the split that misclassifies the fewest.
Split split_by(const Scene& scene, const Limit& limit, double step, double highest);

}  // namespace ricochet::carrier_track::inline counting
