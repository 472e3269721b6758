#include "problems/carrier_track/questions/count.h"

#include <fmt/format.h>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

namespace ricochet::carrier_track::inline questions {

Problem count_problem(const Machine& machine) {
  Problem problem = speed_problem("count", machine, "collision count, equations (31)-(33)");
  define(problem, ObjectiveAtSpeed{machine.scene, 0.0}, false);
  return problem;
}

Problem surrogate_problem(const Machine& machine, double width) {
  Problem problem = judged_as_it_is(count_problem(machine));
  problem.name = fmt::format("surrogate-{}", machine.id);
  problem.source = "smooth surrogate of the collision count";
  define(problem, ObjectiveAtSpeed{machine.scene, width}, carries_derivatives(machine.scene));
  problem.smoothed = [machine](double other) { return surrogate_problem(machine, other); };
  return problem;
}

Family count_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = family.judged_as = "count";
  family.title = "The fewest collisions, shown the count";
  family.question = "At which speed does the carrier hit its track least often?";
  family.formula =
      "Minimise, over the speed of the driver plate, the number of impacts in the window that are "
      "faster than the slowest that counts: the paper's equations (31) to (33). The objective is "
      "a whole number that jumps.";
  family.instances = "One for each machine: the same question of other constants.";
  family.users =
      "Whoever compares solvers on a staircase: it is the paper's own problem, which its fireworks "
      "algorithm solved.";
  for (const Machine& machine : machines) family.problems.push_back(count_problem(machine));
  return family;
}

Family surrogate_family(const std::vector<Machine>& machines) {
  Family family = count_family({});
  family.name = "surrogate";
  family.title = "The fewest collisions, shown the surrogate";
  family.formula = fmt::format(
      "Minimise, over the speed of the driver plate, the sum over all impacts in the window of "
      "weights: one of approach speed v counts 1 / (1 + (v_c / v)^(1 / s)), v_c the "
      "slowest that counts, s = {} the smoothing width: next to nothing where it is born, a half "
      "at v_c. Solvers can ask for other widths. Judged by the true count.",
      default_width);
  family.derivatives = "Exact, by dual numbers carried through the simulation.";
  family.users =
      "Whoever wants to know what gradients are worth where the truth is a staircase, and how a "
      "width that shrinks helps.";
  for (const Machine& machine : machines) {
    family.problems.push_back(surrogate_problem(machine, default_width));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
