#pragma once

#include <limits>
#include <span>
#include <vector>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/models/observer.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

/// objective() for many scenes, with the same bits. If possible they are simulated side by side
/// (impact_lanes.h), which is several times as fast. Neighbours should be similar.
namespace ricochet::carrier_track::inline counting {

/// Counts as objective() does under the rule of impacts, without its logarithm.
struct ImpactCount : Observer {
  static constexpr bool hears_impacts_alone = true;

  struct Enough {};  ///< thrown when the count exceeds `most`

  double counting_limit = 0;
  int most = std::numeric_limits<int>::max();  ///< largest count of interest
  int count = 0;

  void impact(double /*time*/, Wall /*wall*/, double speed) {
    if (is_counted(speed, counting_limit) && ++count > most) throw Enough();
  }
};

/// Returns true if all scenes can be simulated side by side and count impacts.
bool suits_lanes(const Scene& scene);

/// The objectives of valid scenes.
std::vector<double> objectives(std::span<const Scene> scenes, double smoothing);

/// The collision counts of a valid scene at several speeds [rad/s].
std::vector<int> counts_at(const Scene& scene, std::span<const double> speeds);

}  // namespace ricochet::carrier_track::inline counting
