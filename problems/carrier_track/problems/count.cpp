#include "problems/carrier_track/problems/count.h"

#include <cmath>

#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/exclusion.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/problem_from_function.h"
#include "problems/carrier_track/problems/speed_problem.h"

namespace ricochet::carrier_track::inline problems {

Problem count_problem(const Machine& machine) {
  const auto define_at = [scene = machine.scene](Problem& problem, double smoothing) {
    define(problem, ObjectiveAtSpeed{scene, smoothing},
           smoothing > 0 && carries_derivatives(scene));
  };
  Problem frame = speed_problem("count", machine, "collision count, equations (31)-(33)");
  frame.smoothing = default_smoothing;
  frame.tolerance = 0.5;  // the count must be exact
  frame.mirrors = true;   // the forces depend on the square of the speed
  if (suits_lanes(machine.scene)) {
    frame.not_excluded = [scene = machine.scene](double count) {
      return not_excluded(scene, slowest_speed, fastest_speed, std::ceil(count) - 1);
    };
  }
  return smoothable(frame, define_at);
}

}  // namespace ricochet::carrier_track::inline problems
