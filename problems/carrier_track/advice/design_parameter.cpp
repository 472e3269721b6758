#include "problems/carrier_track/advice/design_parameter.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/advice/path_chart.h"
#include "problems/carrier_track/answer/sensitivity.h"

namespace ricochet::studies::advice {
namespace {

using carrier_track::Scene;

/// A restitution after the design parameter's restitution goes from `own` to `value`: it moves by
/// the same share of the way to 0, or to 1.
double gone_with(double restitution, double own, double value) {
  if (value <= own) return own > 0 ? restitution * (value / own) : 0.0;
  return restitution + (1 - restitution) * (value - own) / (1 - own);
}

Scene with_restitution(const Scene& scene, double value) {
  const double own = scene.restitution_lower;
  Scene turned = scene;
  turned.restitution_lower = value;
  turned.restitution_upper = gone_with(scene.restitution_upper, own, value);
  if (turned.across) {
    turned.across->restitution_lower = gone_with(scene.across->restitution_lower, own, value);
    turned.across->restitution_upper = gone_with(scene.across->restitution_upper, own, value);
  }
  return turned;
}

Scene with_friction(const Scene& scene, double value) {
  Scene turned = scene;
  turned.friction = value;
  return turned;
}

double clearance_of(const Scene& scene) {
  return (scene.wall_upper - scene.wall_lower) / millimetre;
}

Scene with_clearance(const Scene& scene, double value) {
  return carrier_track::scaled(scene, "clearance", value / clearance_of(scene));
}

Scene with_disturbance(const Scene& scene, double value) {
  Scene turned = scene;
  turned.disturbance = value;
  return turned;
}

}  // namespace

double DesignParameter::value(double share) const {
  return share < 0 ? own + share * (own - least) : own + share * (most - own);
}

std::vector<double> DesignParameter::levels() const {
  std::vector<double> values;
  for (const double share : shares) {
    const double at = value(share);
    if (values.empty() || at != values.back()) values.push_back(at);
  }
  return values;
}

std::vector<DesignParameter> design_parameters_of(const Scene& scene) {
  const std::vector<double> three{-1, 0, 1};
  const std::vector<double> five{-1, -0.5, 0, 0.5, 1};
  const double restitution = scene.restitution_lower;
  const double friction = scene.friction;
  // With contact friction, a coefficient of 1 or more takes the whole velocity.
  const double slippery = scene.contact_friction ? std::max(friction, 0.99) : 1e15;
  std::vector<DesignParameter> design_parameters = {
      {"restitution", "", restitution / 2, restitution, (1 + restitution) / 2, five,
       with_restitution},
      {"friction", "", 0, friction, std::min(slippery, friction > 0 ? 2 * friction : 0.2), five,
       with_friction}};
  if (std::isfinite(scene.wall_upper)) {
    const double clearance = clearance_of(scene);
    design_parameters.push_back(
        {"clearance", "mm", clearance / 2, clearance, 2 * clearance, three, with_clearance});
  }
  const double force = std::max(std::abs(scene.pull), friction * scene.normal_force);
  if (scene.disturbance != 0) {
    design_parameters.push_back(
        {"disturbance", "N", 0, scene.disturbance, 2 * scene.disturbance, three, with_disturbance});
  } else if (force > 0) {
    design_parameters.push_back({"disturbance", "N", 0, 0, force, five, with_disturbance});
  }
  return design_parameters;
}

}  // namespace ricochet::studies::advice
