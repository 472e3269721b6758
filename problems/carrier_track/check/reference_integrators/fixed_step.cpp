#include "problems/carrier_track/check/reference_integrators/fixed_step.h"

#include "problems/carrier_track/models/impact_model.h"

namespace ricochet::carrier_track::inline reference_integrators {

bool plan_steps(const Scene& scene, double longest, StepPlan& plan, Outcome& outcome) {
  const double window = duration_of(scene);
  const double count = std::ceil(window / longest);
  if (!(count <= most_fixed_steps)) {
    outcome.end = {0.0, scene.start_position, scene.start_velocity};
    outcome.failure = "more than 100000000 steps";
    return false;
  }
  plan = {static_cast<std::int64_t>(count), window / count};
  return true;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
