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

}  // namespace

DesignScale design_scale(const Machine& machine) {
  return {loud_speed(machine), machine.scene.pull, greatest_pull(machine) - least_pull(machine),
          machine.scene.wall_upper - machine.scene.wall_lower};
}

Question design_count_question(const Machine& machine) {
  const DesignScale scale = design_scale(machine);
  const Scene& scene = machine.scene;
  Problem frame;
  frame.name = fmt::format("design-count-{}", machine.id);
  frame.source = "cheapest machine whose collision count is quiet";
  frame.variables = {
      {"speed", "rad/s"}, {"pull", "N"}, {"clearance", "m"}, {"friction", ""}, {"restitution", ""}};
  frame.lower.resize(design_size);
  frame.upper.resize(design_size);
  frame.start.resize(design_size);
  frame.lower << 0.5, least_pull(machine), 0.5 * scale.clearance, 0.05, 0.05;
  frame.upper << fastest_speed, greatest_pull(machine), 2 * scale.clearance, 0.5, 0.95;
  frame.start << scale.speed / 2, scale.pull, scale.clearance, scene.friction,
      scene.restitution_lower;
  frame.start = frame.start.cwiseMax(frame.lower).cwiseMin(frame.upper);
  know_best(frame, machine.reading);
  const auto define_at = [machine, scale](Problem& problem, double width) {
    define(problem, Cost{scale}, ObjectiveOfDesign{machine.scene, width},
           width > 0 ? half_level(machine.quiet_limit) : machine.quiet_limit,
           width > 0 && carries_derivatives(machine.scene));
  };
  return {.stated = smoothable(frame, define_at),
          .machine = machine.id,
          .width = default_width,
          .tolerance = 0.01,
          .penalty_weight = 10};  // a collision too many costs more than any speed earns
}

Family design_count_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = "design-count";
  family.title = "The machine and its speed together";
  family.asks =
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
  family.constraints = "Collision count <= the quiet limit of the machine as it is.";
  family.surrogate = "Smooth surrogate <= the highest quiet count and a half.";
  family.derivatives =
      "Exact, of the surrogate, by dual numbers carried through the simulation, to all five "
      "variables.";
  family.instances =
      "One for each machine with two walls, by its nominal values, window and quiet limit. The "
      "machine's own friction and restitution are but the start: cases that differ in nothing else "
      "ask nearly the same.";
  family.users =
      "A designer of machines; whoever compares solvers on five variables of different kinds, a "
      "smooth objective and one constraint that is active at the best.";
  for (const Machine& machine : machines) {
    if (has_clearance(machine)) family.questions.push_back(design_count_question(machine));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
