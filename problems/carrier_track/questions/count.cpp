#include "problems/carrier_track/questions/count.h"

#include <fmt/format.h>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

namespace ricochet::carrier_track::inline questions {

Question count_question(const Machine& machine) {
  const auto define_at = [scene = machine.scene](Problem& problem, double width) {
    define(problem, ObjectiveAtSpeed{scene, width}, width > 0 && carries_derivatives(scene));
  };
  return {.stated = smoothable(
              speed_problem("count", machine, "collision count, equations (31)-(33)"), define_at),
          .machine = machine.id,
          .width = default_width,
          .tolerance = 0.5};  // a count must be met
}

}  // namespace ricochet::carrier_track::inline questions
