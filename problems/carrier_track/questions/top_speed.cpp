#include "problems/carrier_track/questions/top_speed.h"

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

namespace ricochet::carrier_track::inline questions {

Question top_speed_question(const Machine& machine) {
  return top_speed_question_of("top-speed", machine);
}

Question top_speed_question_of(const std::string& family, const Machine& machine) {
  const auto define_at = [machine](Problem& problem, double width) {
    define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, width},
           width > 0 ? half_level(machine.quiet_limit) : machine.quiet_limit,
           width > 0 && carries_derivatives(machine.scene));
  };
  return {.stated = smoothable(
              speed_problem(family, machine, "fastest speed whose collision count is quiet"),
              define_at),
          .machine = machine.id,
          .width = default_width,
          .tolerance = speed_tolerance,
          .penalty_weight = speed_penalty};
}

}  // namespace ricochet::carrier_track::inline questions
