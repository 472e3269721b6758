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

}  // namespace

bool has_clearance(const Machine& machine) {
  return std::isfinite(machine.scene.wall_upper);
}

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

}  // namespace ricochet::carrier_track::inline questions
