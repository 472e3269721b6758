#pragma once

#include <limits>
#include <span>
#include <vector>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/observer.h"
#include "problems/carrier_track/scene/scene.h"

/// What objective() tells of many scenes, to the same bits: side by side (impact_lanes.h) where
/// that can be done, which is some times as fast. Neighbours should be similar.
namespace ricochet::carrier_track::inline counting {

/// Counts as objective() does under the rule of impacts, without its logarithm.
struct ImpactCount : Observer {
  static constexpr bool hears_impacts_alone = true;

  struct Enough {};  ///< thrown by the impact after the last that is of interest

  double slowest = 0;
  int most = std::numeric_limits<int>::max();  ///< of interest
  int count = 0;

  void impact(double /*time*/, Wall /*wall*/, double speed) {
    if (is_counted(speed, slowest) && ++count > most) throw Enough();
  }
};

/// Whether all can be simulated side by side, and their counts are of impacts.
bool suits_lanes(const Scene& scene);

/// The objectives of valid scenes.
std::vector<double> objectives(std::span<const Scene> scenes, double width);

/// The collision counts of a valid scene at several speeds [rad/s].
std::vector<int> counts_at(const Scene& scene, std::span<const double> speeds);

}  // namespace ricochet::carrier_track::inline counting
