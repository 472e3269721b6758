#include "problems/carrier_track/events/stick_release.h"

#include <algorithm>
#include <limits>

#include "problems/carrier_track/events/step_bound.h"
#include "problems/carrier_track/flight/ramp_flight.h"

namespace ricochet::carrier_track::inline events {

template <class Path>
Event next_release(const Path& applied, double friction, bool may_rise, bool may_fall,
                   double horizon, std::int64_t& evaluations) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const ForceBounds bounds = applied.bounds(horizon);
  const double noise = 4 * epsilon * (bounds.acceleration + friction);
  const double slope_noise = 4 * epsilon * bounds.jerk;
  if (bounds.jerk <= 0) return {EventKind::horizon, horizon, 0};
  double time = 0;
  double least_step = bounds.shortest_step;
  for (;;) {
    const auto [push, slope] = applied.applied_at(time);
    ++evaluations;
    double step = infinity;
    bool at_the_edge = false;
    for (const int direction : {+1, -1}) {
      if (direction > 0 ? !may_rise : !may_fall) continue;
      const double reserve = friction - direction * push;
      const double reserve_slope = -direction * slope;
      // The force is already outside the band by more than the rounding of cancelling forces: it
      // jumps at a knot of a speed profile.
      const bool jumped = reserve < -1e-9 * (bounds.acceleration + friction);
      if (jumped || (reserve <= noise && reserve_slope < -slope_noise)) {
        return {EventKind::release, time, direction};
      }
      step = std::min(step, step_bound(std::max(reserve, 0.0), reserve_slope, bounds.snap));
      at_the_edge = at_the_edge || reserve <= noise;
    }
    // While the force equals the band's edge within rounding, steps double.
    least_step = at_the_edge ? 2 * least_step : bounds.shortest_step;
    if (at_the_edge) step = std::max(step, least_step);
    if (time >= horizon || step == infinity) return {EventKind::horizon, horizon, 0};
    time = std::min(time + std::max(step, epsilon * time), horizon);
  }
}

template Event next_release(const Flight<double>&, double, bool, bool, double, std::int64_t&);
template Event next_release(const RampFlight<double>&, double, bool, bool, double, std::int64_t&);

}  // namespace ricochet::carrier_track::inline events
