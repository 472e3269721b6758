#include "problems/carrier_track/identification/safe_speed.h"

#include "ricochet/regimes.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline identification {

std::optional<double> safe_speed(const Scene& scene, double fastest) {
  Scene from_rest = at_speed(scene, fastest);
  from_rest.start_position = scene.wall_lower;
  from_rest.start_velocity = 0;
  const RegimeOptions range{fastest / 200, fastest};
  const double quiet = quiet_up_to(from_rest, quiet_per_turn, range).value_or(range.from);
  return quiet < fastest ? std::optional(quiet) : std::nullopt;
}

}  // namespace ricochet::carrier_track::inline identification
