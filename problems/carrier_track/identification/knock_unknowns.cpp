#include "problems/carrier_track/identification/knock_unknowns.h"

#include <algorithm>
#include <cmath>

namespace ricochet::carrier_track::inline identification {
namespace {

double logit(double share) {
  return std::log(share / (1 - share));
}

double share_at(double logit) {
  return 1 / (1 + std::exp(-logit));
}

}  // namespace

Vector point_of(const KnockUnknowns& u) {
  Vector x(knock_unknowns);
  x << logit(u.restitution), std::log(u.friction), std::log(u.clearance), u.phase,
      std::log(u.speed_factor), std::log(u.jitter), logit(u.recorded_share),
      std::log(u.spurious_rate), std::log(u.detection_limit), std::log(u.gain), std::log(u.scatter),
      logit(u.upper_share), u.lag, u.drift;
  return x;
}

KnockUnknowns unknowns_at(const Vector& x) {
  return {.restitution = share_at(x[0]),
          .friction = std::exp(x[1]),
          .clearance = std::exp(x[2]),
          .phase = x[3],
          .speed_factor = std::exp(x[4]),
          .jitter = std::exp(x[5]),
          .recorded_share = share_at(x[6]),
          .spurious_rate = std::exp(x[7]),
          .detection_limit = std::exp(x[8]),
          .gain = std::exp(x[9]),
          .scatter = std::exp(x[10]),
          .upper_share = share_at(x[11]),
          .lag = x[12],
          .drift = x[13]};
}

Vector slopes_at(const Vector& x) {
  const KnockUnknowns u = unknowns_at(x);
  Vector slopes(machine_constants);
  slopes << u.restitution * (1 - u.restitution), u.friction, u.clearance;
  return slopes;
}

KnockUnknowns guess_of(const Scene& scene) {
  return {.restitution = std::clamp(scene.restitution_lower, 0.01, 0.99),
          .friction = std::max(scene.friction, 1e-3),
          .clearance = scene.wall_upper - scene.wall_lower,
          .phase = scene.phase,
          .speed_factor = 1,
          .jitter = 1e-3,
          .recorded_share = 0.9,
          .spurious_rate = 0.2,
          .detection_limit = scene.counting_limit,
          .gain = 1,
          .scatter = 0.1};
}

Scene with_constants(Scene scene, const KnockUnknowns& unknowns) {
  scene.restitution_lower = scene.restitution_upper = unknowns.restitution;
  scene.friction = unknowns.friction;
  scene.wall_upper = scene.wall_lower + unknowns.clearance;
  scene.start_position = scene.wall_lower;
  return scene;
}

}  // namespace ricochet::carrier_track::inline identification
