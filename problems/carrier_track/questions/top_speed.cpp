#include "problems/carrier_track/questions/top_speed.h"

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

namespace ricochet::carrier_track::inline questions {

Question top_speed_question(const Machine& machine) {
  const auto define_at = [machine](Problem& problem, double width) {
    define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, width},
           width > 0 ? half_level(machine.quiet_limit) : machine.quiet_limit,
           width > 0 && carries_derivatives(machine.scene));
  };
  return {.stated = smoothable(
              speed_problem("top-speed", machine, "fastest speed whose collision count is quiet"),
              define_at),
          .machine = machine.id,
          .width = default_width,
          .tolerance = speed_tolerance,
          .penalty_weight = speed_penalty};
}

Family top_speed_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = "top-speed";
  family.title = "The fastest quiet speed";
  family.asks = "How fast may the machine turn with no more collisions than usual?";
  family.formula = "Minimise the speed's negative.";
  family.constraints =
      "Collision count <= quiet limit, 1.5 times the count that is most common below the "
      "threshold that the paper claims (where it claims none, below 1.8 rad/s).";
  family.surrogate =
      "Smooth surrogate <= the highest quiet count and a half. A count is whole, and an impact "
      "counts half just where it begins to count: so the surrogate passes this level, but for the "
      "tails of other impacts, where the count leaves the limit.";
  family.derivatives = "Exact, of the surrogate, by dual numbers carried through the simulation.";
  family.instances = "One for each machine, with a limit of its own.";
  family.users =
      "An engineer who wants the most from a machine; whoever compares how solvers treat a "
      "constraint that jumps. Quiet speeds may lie beyond loud ones.";
  for (const Machine& machine : machines) family.questions.push_back(top_speed_question(machine));
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
