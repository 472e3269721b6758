#include "problems/carrier_track/questions/design.h"

#include <fmt/format.h>

#include <algorithm>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_range.h"

namespace ricochet::carrier_track::inline questions {
namespace {

constexpr double further_pull = 5.0;  // [N] beyond twice the nominal one, or none

struct ObjectiveOfDesign {
  static constexpr int jet_size = design_size;

  Scene scene;
  double width;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> built = designed(scene, x);
    auto watching = watch.of(built);
    return objective(built, width, watching);
  }
};

struct Cost {
  static constexpr int jet_size = design_size;

  DesignScale scale;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& /*watch*/) const {
    return design_cost(scale, x).sum();
  }
};

double least_pull(const Machine& machine) {
  return std::min(0.0, 2 * machine.scene.pull);
}

double greatest_pull(const Machine& machine) {
  return std::max(0.0, 2 * machine.scene.pull) + further_pull;
}

bool has_clearance(const Machine& machine) {
  return std::isfinite(machine.scene.wall_upper);
}

/// What the two families share.
Family family_named(std::string name) {
  Family family;
  family.name = std::move(name);
  family.judged_as = "design-count";
  family.question =
      "Which speed, yarn pull, clearance, friction and restitution together make the best machine "
      "that is still quiet?";
  family.formula =
      "Minimise a cost without dimension. Speed earns, -speed / nominal. A small clearance costs "
      "precision, 0.5 nominal / clearance. Strong damping costs 0.25 ln(1 / restitution): layers "
      "that each keep the same share of the speed. Friction costs heat, 0.5 friction (speed / "
      "nominal)^3: its power, under a press that grows as centrifugal force does. A pull that "
      "departs from its nominal value costs the braid's quality, the square "
      "of the departure over the span of the bounds. Nominal are the machine's own pull and "
      "clearance, and the speed of the profiles.";
  family.instances =
      "One for each machine with two walls, by its nominal values, window and quiet limit. The "
      "machine's own friction and restitution are but the start: cases that differ in nothing else "
      "ask nearly the same.";
  family.users =
      "A designer of machines; whoever compares solvers on five variables of different kinds, a "
      "smooth objective and one constraint that is active at the best.";
  return family;
}

}  // namespace

DesignScale design_scale(const Machine& machine) {
  return {loud_speed(machine), machine.scene.pull, greatest_pull(machine) - least_pull(machine),
          machine.scene.wall_upper - machine.scene.wall_lower};
}

Problem design_count_problem(const Machine& machine) {
  const DesignScale scale = design_scale(machine);
  const Scene& scene = machine.scene;
  Problem problem;
  problem.name = fmt::format("design-count-{}", machine.id);
  problem.source = "cheapest machine whose collision count is quiet";
  problem.variables = {
      {"speed", "rad/s"}, {"pull", "N"}, {"clearance", "m"}, {"friction", ""}, {"restitution", ""}};
  problem.lower.resize(design_size);
  problem.upper.resize(design_size);
  problem.start.resize(design_size);
  problem.lower << 0.5, least_pull(machine), 0.5 * scale.clearance, 0.05, 0.05;
  problem.upper << fastest_speed, greatest_pull(machine), 2 * scale.clearance, 0.5, 0.95;
  problem.start << scale.speed / 2, scale.pull, scale.clearance, scene.friction,
      scene.restitution_lower;
  problem.start = problem.start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  problem.constraints = 1;
  define(problem, Cost{scale}, ObjectiveOfDesign{scene, 0.0}, machine.quiet_limit, false);
  know_best(problem, machine.reading);
  return problem;
}

Problem design_problem(const Machine& machine, double width) {
  Problem problem = judged_as_it_is(design_count_problem(machine));
  problem.name = fmt::format("design-{}", machine.id);
  problem.source = "cheapest machine whose smooth surrogate is quiet";
  define(problem, Cost{design_scale(machine)}, ObjectiveOfDesign{machine.scene, width},
         half_level(machine.quiet_limit), carries_derivatives(machine.scene));
  problem.smoothed = [machine](double other) { return design_problem(machine, other); };
  return problem;
}

Family design_count_family(const std::vector<Machine>& machines) {
  Family family = family_named("design-count");
  family.title = "The machine and its speed together, shown the count";
  family.constraints = "Collision count <= the quiet limit of the machine as it is.";
  for (const Machine& machine : machines) {
    if (has_clearance(machine)) family.problems.push_back(design_count_problem(machine));
  }
  return family;
}

Family design_family(const std::vector<Machine>& machines) {
  Family family = family_named("design");
  family.title = "The machine and its speed together, shown the surrogate";
  family.constraints =
      "Smooth surrogate <= the highest quiet count and a half; judged by the true count.";
  family.derivatives =
      "Exact, by dual numbers carried through the simulation, to all five variables.";
  for (const Machine& machine : machines) {
    if (has_clearance(machine)) family.problems.push_back(design_problem(machine, default_width));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
