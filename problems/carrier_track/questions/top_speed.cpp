#include "problems/carrier_track/questions/top_speed.h"

#include <fmt/format.h>

#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

namespace ricochet::carrier_track::inline questions {

Problem top_speed_problem(const Machine& machine) {
  Problem problem =
      speed_problem("top-speed", machine, "fastest speed whose collision count is quiet");
  problem.constraints = 1;
  define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, 0.0}, machine.quiet_limit, false);
  return problem;
}

Problem top_speed_surrogate_problem(const Machine& machine, double width) {
  Problem problem = judged_as_it_is(top_speed_problem(machine));
  problem.name = fmt::format("top-speed-surrogate-{}", machine.id);
  problem.source = "fastest speed whose smooth surrogate is quiet";
  define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, width},
         half_level(machine.quiet_limit), carries_derivatives(machine.scene));
  problem.smoothed = [machine](double other) {
    return top_speed_surrogate_problem(machine, other);
  };
  return problem;
}

Family top_speed_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = family.judged_as = "top-speed";
  family.title = "The fastest quiet speed, shown the count";
  family.question = "How fast may the machine turn with no more collisions than usual?";
  family.formula = "Minimise the speed's negative.";
  family.constraints =
      "Collision count <= quiet limit, 1.5 times the count that is most common below the "
      "threshold that the paper claims (where it claims none, below 1.8 rad/s).";
  family.instances = "One for each machine, with a limit of its own.";
  family.users =
      "An engineer who wants the most from a machine; whoever compares how solvers treat a "
      "constraint that jumps. Quiet speeds may lie beyond loud ones.";
  for (const Machine& machine : machines) family.problems.push_back(top_speed_problem(machine));
  return family;
}

Family top_speed_surrogate_family(const std::vector<Machine>& machines) {
  Family family = top_speed_family({});
  family.name = "top-speed-surrogate";
  family.title = "The fastest quiet speed, shown the surrogate";
  family.constraints =
      "Smooth surrogate <= the highest quiet count and a half. A count is whole, and an impact "
      "counts half just where it begins to count: so the surrogate passes this level, but for the "
      "tails of other impacts, where the count leaves the limit. Judged by the true count.";
  family.derivatives = "Exact, by dual numbers carried through the simulation.";
  family.users = "Solvers of constrained problems that want derivatives.";
  for (const Machine& machine : machines) {
    family.problems.push_back(top_speed_surrogate_problem(machine, default_width));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
