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

Family count_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = "count";
  family.title = "The fewest collisions";
  family.asks = "At which speed does the carrier hit its track least often?";
  family.formula =
      "Minimise, over the speed of the driver plate, the number of impacts in the window that are "
      "faster than the slowest that counts: the paper's equations (31) to (33). The objective is "
      "a whole number that jumps.";
  family.surrogate = fmt::format(
      "The sum over all impacts in the window of weights: one of approach speed v counts "
      "1 / (1 + (v_c / v)^(1 / s)), v_c the slowest that counts, s = {} the smoothing width: next "
      "to nothing where it is born, a half at v_c.",
      default_width);
  family.derivatives = "Exact, of the surrogate, by dual numbers carried through the simulation.";
  family.instances = "One for each machine: the same question of other constants.";
  family.users =
      "Whoever compares solvers on a staircase: it is the paper's own problem, which its fireworks "
      "algorithm solved. Or wants to know what gradients are worth where the truth is a staircase, "
      "and how a width that shrinks helps.";
  for (const Machine& machine : machines) family.questions.push_back(count_question(machine));
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
