#include "problems/carrier_track/suite/speed_problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline problems {

Problem count_problem(const Machine& machine) {
  const auto define_at = [scene = machine.scene](Problem& problem, double smoothing) {
    define(problem, ObjectiveAtSpeed{scene, smoothing},
           smoothing > 0 && carries_derivatives(scene));
  };
  Problem frame = speed_problem("count", machine, "collision count, equations (31)-(33)");
  frame.smoothing = default_smoothing;
  frame.tolerance = 0.5;  // the count must be exact
  frame.mirrors = true;   // the forces depend on the square of the speed
  if (suits_lanes(machine.scene)) {
    frame.not_excluded = [scene = machine.scene](double count) {
      return not_excluded(scene, slowest_speed, fastest_speed, std::ceil(count) - 1);
    };
  }
  return smoothable(frame, define_at);
}

Problem top_speed_problem(const Machine& machine) {
  return top_speed_problem_of("top-speed", machine);
}

Problem top_speed_problem_of(const std::string& family, const Machine& machine) {
  const auto define_at = [machine](Problem& problem, double smoothing) {
    define(problem, Slowness{}, ObjectiveAtSpeed{machine.scene, smoothing},
           smoothing > 0 ? half_level(machine.quiet_limit) : std::floor(machine.quiet_limit),
           smoothing > 0 && carries_derivatives(machine.scene));
  };
  Problem frame = speed_problem(family, machine, "fastest speed whose collision count is quiet");
  frame.unit = "rad/s";
  frame.maximises = true;
  frame.smoothing = default_smoothing;
  frame.tolerance = speed_tolerance;
  frame.penalty_weight = speed_penalty;
  if (suits_lanes(machine.scene)) {
    frame.not_excluded = [machine](double objective) {
      const double faster = -objective + speed_tolerance;
      return not_excluded(machine.scene, faster, fastest_speed, machine.quiet_limit);
    };
  }
  return smoothable(frame, define_at);
}

Problem speed_problem(const std::string& family, const Machine& machine, std::string source) {
  Problem problem;
  problem.name = fmt::format("{}-{}", family, machine.id);
  problem.source = std::move(source);
  problem.variables = {{"speed", "rad/s"}};
  problem.lower = Vector::Constant(1, slowest_speed);
  problem.upper = Vector::Constant(1, fastest_speed);
  problem.start = Vector::Constant(1, (slowest_speed + fastest_speed) / 2);
  problem.machine = machine.id;
  know_best(problem, machine.default_hash);
  return problem;
}

namespace {

Scene between_hard_walls(Scene scene) {
  scene.fidelity = Fidelity::impact;
  scene.across.reset();
  return scene;
}

}  // namespace

int most_collisions_below(const Scene& scene, double end, double step) {
  std::vector<double> speeds;
  for (double k = std::ceil(limit_from * end / step); k * step < end; ++k) {
    speeds.push_back(k * step);
  }
  if (speeds.empty()) speeds.push_back(end);
  const std::vector<int> counts = counts_at(scene, speeds);
  return *std::max_element(counts.begin(), counts.end());
}

QuietRule quiet_rule_of(const Scene& scene, double step) {
  const Scene hard = between_hard_walls(scene);
  const std::optional<double> border =
      has_regimes(hard) ? quiet_up_to(hard, quiet_per_turn, {slowest_speed, fastest_speed})
                        : std::nullopt;
  if (!border) {
    const Score found = score(scene, Claim{}, ScanOptions{step, step < 0.01 ? 10U : 1U});
    return {quiet_limit(found.quiet_count), found.threshold};
  }
  return {most_collisions_below(scene, *border, step) + 0.5,
          *border < fastest_speed ? border : std::nullopt};
}

}  // namespace ricochet::carrier_track::inline problems
