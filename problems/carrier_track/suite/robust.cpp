#include "problems/carrier_track/suite/robust.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <type_traits>

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/random.h"
#include "src/core/instance.h"

namespace ricochet::carrier_track::inline problems {

namespace {

enum Draw : std::size_t {
  of_phase,
  of_amplitude,
  of_clearance,
  of_mass,
  of_friction,
  of_restitution,
  draw_size
};

using Draws = std::array<double, draw_size>;  // in [0, 1)

constexpr double amplitude_tolerance = 0.2;
constexpr double further_amplitude = 0.05;  // [N]
constexpr double clearance_tolerance = 0.05;
constexpr double mass_tolerance = 0.02;
constexpr double friction_tolerance = 0.1;
constexpr double restitution_tolerance = 0.05;

double unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

std::vector<Draws> draws() {
  Random random(seed_of("robust", "draws", 0, 0));
  Draws shift;
  for (double& s : shift) s = unit(random());
  std::vector<Draws> all(robust_samples);
  // The library leaves out the sequence's first point, the origin.
  boost::random::sobol sequence(draw_size);
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t i = 0; i < draw_size; ++i) {
      const double drawn = (k == 0 ? 0.0 : unit(sequence())) + shift[i];
      all[k][i] = drawn < 1 ? drawn : drawn - 1;
    }
  }
  return all;
}

/// 1 to within a tolerance.
double factor(double draw, double tolerance) {
  return 1 + tolerance * (2 * draw - 1);
}

/// The risk of the objectives of all scenes at the speed x[0].
struct RiskAtSpeed {
  static constexpr int jet_size = 1;

  std::shared_ptr<const std::vector<Scene>> scenes;
  RiskMeasure risk;
  double smoothing;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    std::vector<Scalar> losses;
    if constexpr (std::is_same_v<Scalar, double>) {  // without derivatives: simulate in lanes
      std::vector<Scene> at;
      for (const Scene& scene : *scenes) at.push_back(at_speed(scene, x[0]));
      return risk_of(risk, objectives(at, smoothing));
    }
    for (const Scene& scene : *scenes)
      losses.push_back(ObjectiveAtSpeed{scene, smoothing}(x, watch));
    return risk_of(risk, std::move(losses));
  }
};

/// The smallest step of a risk: the weight of the least weighted impact.
double step_of(RiskMeasure risk) {
  double least = 1;
  for (const double w : risk_weights(risk, robust_samples)) {
    if (w > 0) least = std::min(least, w);
  }
  return least;
}

std::string prefix(RiskMeasure risk) {
  return fmt::format("robust-{}", name_of(risk));
}

}  // namespace

std::vector<Scene> sampled_scenes(const Scene& scene) {
  static const std::vector<Draws> all = draws();
  std::vector<Scene> scenes;
  for (const Draws& d : all) {
    Scene sample = scaled_clearance(factor(d[of_clearance], clearance_tolerance), scene);
    sample.disturbance =
        scene.disturbance * factor(d[of_amplitude], amplitude_tolerance) + further_amplitude;
    sample.disturbance_phase = 2 * std::numbers::pi * d[of_phase];
    const double mass = factor(d[of_mass], mass_tolerance);
    sample.mass *= mass;
    sample.centrifugal_mass_radius *= mass;
    sample.friction *= factor(d[of_friction], friction_tolerance);
    if (scene.contact_friction) sample.friction = std::min(sample.friction, 1.0);
    for (double* restitution : {&sample.restitution_lower, &sample.restitution_upper}) {
      *restitution =
          std::clamp(*restitution * factor(d[of_restitution], restitution_tolerance), 0.0, 1.0);
    }
    scenes.push_back(std::move(sample));
  }
  return scenes;
}

Problem robust_problem(const Machine& machine, RiskMeasure risk) {
  const double step = step_of(risk);
  const double limit = machine.quiet_limit;
  const auto define_at =
      [scenes = std::make_shared<const std::vector<Scene>>(sampled_scenes(machine.scene)), risk,
       limit, half_a_step_above = half_level(limit / step + 1e-9) * step](Problem& problem,
                                                                          double smoothing) {
        define(problem, Slowness{}, RiskAtSpeed{scenes, risk, smoothing},
               smoothing > 0 ? half_a_step_above : limit,
               smoothing > 0 && carries_derivatives(scenes->front()));
      };
  Problem frame = speed_problem(
      prefix(risk), machine,
      fmt::format("fastest speed whose {} of 32 sampled counts is quiet", name_of(risk)));
  frame.unit = "rad/s";
  frame.maximises = true;
  frame.smoothing = default_smoothing;
  frame.tolerance = speed_tolerance;
  frame.penalty_weight = speed_penalty / step;
  frame.cost = robust_samples;
  frame.gradient_cost = robust_gradient_cost;
  return smoothable(frame, define_at);
}

}  // namespace ricochet::carrier_track::inline problems
