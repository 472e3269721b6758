#include "problems/carrier_track/suite/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "problems/carrier_track/suite/speed_problems.h"

namespace ricochet::carrier_track::inline problems {

namespace {

constexpr double further_pull = 5.0;  // [N] allowed beyond twice the nominal pull

struct ObjectiveOfDesign {
  static constexpr int jet_size = design_size;

  Scene scene;
  double smoothing;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> built = designed(scene, x);
    auto watching = watch.of(built);
    return objective(built, smoothing, watching);
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

Problem design_count_problem(const Machine& machine) {
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
  frame.machine = machine.id;
  frame.smoothing = default_smoothing;
  frame.tolerance = 0.01;
  frame.penalty_weight = 10;  // one collision too many costs more than any speed gains
  know_best(frame, machine.default_hash);
  const auto define_at = [machine, scale](Problem& problem, double smoothing) {
    define(problem, Cost{scale}, ObjectiveOfDesign{machine.scene, smoothing},
           smoothing > 0 ? half_level(machine.quiet_limit) : std::floor(machine.quiet_limit),
           smoothing > 0 && carries_derivatives(machine.scene));
  };
  return smoothable(frame, define_at);
}

}  // namespace ricochet::carrier_track::inline problems
