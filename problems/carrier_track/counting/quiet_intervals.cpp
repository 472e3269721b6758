#include "problems/carrier_track/counting/quiet_pockets.h"

namespace ricochet::carrier_track::inline counting {

std::vector<Pocket> quiet_pockets(const SpeedScan& scan, double limit) {
  std::vector<Pocket> pockets;
  bool within = false;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool quiet = scan.counts[k] <= limit;
    if (quiet && !within) pockets.push_back({scan.omega(k), scan.omega(k)});
    if (quiet) pockets.back().to = scan.omega(k);
    within = quiet;
  }
  return pockets;
}

}  // namespace ricochet::carrier_track::inline counting
