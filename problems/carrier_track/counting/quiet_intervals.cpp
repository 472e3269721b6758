#include "problems/carrier_track/counting/quiet_intervals.h"

#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {

std::vector<QuietInterval> quiet_intervals(const SpeedScan& scan, double limit) {
  std::vector<QuietInterval> quiet_intervals;
  bool within = false;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool quiet = scan.counts[k] <= limit;
    if (quiet && !within) quiet_intervals.push_back({scan.omega(k), scan.omega(k)});
    if (quiet) quiet_intervals.back().to = scan.omega(k);
    within = quiet;
  }
  return quiet_intervals;
}

}  // namespace ricochet::carrier_track::inline counting
