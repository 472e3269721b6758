#include "problems/carrier_track/problems/top_speed.h"

#include <cmath>

#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/exclusion.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/problem_from_function.h"
#include "problems/carrier_track/problems/speed_problem.h"

namespace ricochet::carrier_track::inline problems {

Problem top_speed_problem(const Machine& machine) {
  return top_speed_problem_of("top-speed", machine);
}

Problem top_speed_problem_of(const std::string& family, const Machine& machine) {
  const auto define_at = [machine](Problem& problem, double smoothing) {
    define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, smoothing},
           smoothing > 0 ? half_level(machine.quiet_limit) : std::floor(machine.quiet_limit),
           smoothing > 0 && carries_derivatives(machine.scene));
  };
  Problem frame = speed_problem(family, machine, "fastest speed whose collision count is quiet");
  frame.unit = "rad/s";
  frame.maximises = true;
  frame.smoothing = default_smoothing;
  frame.tolerance = speed_tolerance;
  frame.penalty_weight = speed_penalty;
  if (suits_lanes(machine.scene)) {
    frame.not_excluded = [machine](double objective) {
      const double faster = -objective + speed_tolerance;
      return not_excluded(machine.scene, faster, fastest_speed, machine.quiet_limit);
    };
  }
  return smoothable(frame, define_at);
}

}  // namespace ricochet::carrier_track::inline problems
