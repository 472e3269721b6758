#include "problems/carrier_track/counting/step_sharpness.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {
namespace {

/// The median; for an even number of counts the upper of the two middle ones, so that it is one of
/// the counts.
int middle_count(std::vector<int> counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle;
}

/// The number of counts before the best split into counts <= `limit` and counts > `limit`.
double speeds_before(const std::vector<int>& counts, int limit) {
  // With a quiet speed first and a loud one last, a split always exists.
  SpeedScan closed{1, {std::numeric_limits<int>::min()}};
  closed.counts.insert(closed.counts.end(), counts.begin(), counts.end());
  closed.counts.push_back(std::numeric_limits<int>::max());
  return *best_split(closed, limit).speed - 1.5;
}

}  // namespace

std::optional<StepSharpness> step_sharpness(const SpeedScan& scan, double threshold, double limit,
                                            double reach) {
  std::vector<int> below, above;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const double omega = scan.omega(k);
    if (omega < threshold / reach || omega > threshold * reach) continue;
    (omega < threshold ? below : above).push_back(scan.counts[k]);
  }
  if (below.empty() || above.empty()) return std::nullopt;

  StepSharpness result{threshold, middle_count(below), middle_count(above), 0, 0, Rise::none};
  const auto loud =
      std::count_if(above.begin(), above.end(), [&](int count) { return count > limit; });
  result.persistence = static_cast<double>(loud) / static_cast<double>(above.size());

  std::vector<int> both = below;
  both.insert(both.end(), above.begin(), above.end());
  result.width = scan.step * std::max(0.0, speeds_before(both, result.after - 1) -
                                               speeds_before(both, result.before));

  if (result.persistence >= least_persistence) {
    const bool sharp = result.after >= quiet_limit(result.before) && result.after > result.before &&
                       result.width <= widest_step * threshold;
    result.rise = sharp ? Rise::step : Rise::climb;
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline counting
