#include "problems/carrier_track/counting/limit.h"

#include <algorithm>

#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/recording.h"
#include "ricochet/threshold.h"
#include "ricochet/time_limit.h"

namespace ricochet::carrier_track::inline counting {
namespace {

struct FastestImpact : Observer {
  double speed = 0;

  void impact(double /*time*/, Wall /*wall*/, double approach) {
    speed = std::max(speed, approach);
  }
};

}  // namespace

double measured(const Scene& scene, Measure measure) {
  switch (measure) {
    case Measure::collisions:
      return objective(scene, 0.0);
    case Measure::collisions_per_turn:
      return objective(scene, 0.0) / turns_of(scene);
    case Measure::energy:
      return 1e-3 * wear(scene);
    case Measure::impact_speed:
      break;
  }
  FastestImpact fastest;
  simulate_at_needed_fidelity(scene, fastest);
  return fastest.speed;
}

std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds) {
  std::vector<double> result;
  if (measure == Measure::collisions) {
    const std::vector<int> counts = counts_at(scene, speeds);
    result.assign(counts.begin(), counts.end());
  } else {
    for (const double omega : speeds) result.push_back(measured(at_speed(scene, omega), measure));
  }
  return result;
}

SpeedScan scan_by(const Scene& scene, const Limit& limit, double step, double highest) {
  const auto loud = [&](double omega) {
    return measured(at_speed(scene, omega), limit.measure) > limit.at_most ? 1 : 0;
  };
  return scan_slowest_speeds(loud, step, highest);
}

Split split_by(const Scene& scene, const Limit& limit, double step, double highest) {
  const SpeedScan scan = scan_by(scene, limit, step, highest);
  if (!extends_to(scan, highest)) throw TimeLimitReached();
  return best_split(scan, 0.5);
}

}  // namespace ricochet::carrier_track::inline counting
