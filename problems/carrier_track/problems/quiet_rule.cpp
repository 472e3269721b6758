#include "problems/carrier_track/problems/quiet_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/regimes.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline problems {
namespace {

Scene between_hard_walls(Scene scene) {
  scene.fidelity = Fidelity::impact;
  scene.across.reset();
  return scene;
}

/// The most collisions in the window at multiples of the step from limit_from * `end` to `end`; at
/// `end` itself if there is no such multiple.
int most_collisions_below(const Scene& scene, double end, double step) {
  std::vector<double> speeds;
  for (double k = std::ceil(limit_from * end / step); k * step < end; ++k) {
    speeds.push_back(k * step);
  }
  if (speeds.empty()) speeds.push_back(end);
  return std::ranges::max(counts_at(scene, speeds));
}

}  // namespace

QuietRule quiet_rule_of(const Scene& scene, double step) {
  const Scene hard = between_hard_walls(scene);
  const std::optional<double> border =
      has_regimes(hard) ? quiet_up_to(hard, quiet_per_turn, {slowest_speed, fastest_speed})
                        : std::nullopt;
  if (!border) {
    const Score found = score(scene, Claim{}, ScanOptions{step, step < 0.01 ? 10U : 1U});
    return {quiet_limit(found.quiet_count), found.threshold};
  }
  return {most_collisions_below(scene, *border, step) + 0.5,
          *border < fastest_speed ? border : std::nullopt};
}

}  // namespace ricochet::carrier_track::inline problems
