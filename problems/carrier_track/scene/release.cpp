#include "problems/carrier_track/scene/release.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace ricochet::carrier_track::inline scene {
namespace {

constexpr double fastest_plate = 1000;  // [rad/s]

/// What the swing has left after the steady part and friction [N].
double excess(const Scene& scene, double omega) {
  const AppliedForce force = applied_force(scene, omega);
  return force.swing - force.steady - scene.friction * scene.normal_force;
}

}  // namespace

AppliedForce applied_force(const Scene& scene, double omega) {
  const double square = omega * omega;
  const double radial = scene.centrifugal_mass_radius * square;
  double steady = 0;
  std::complex<double> turning = -scene.slider_mass_radius * square;  // times cos alpha
  switch (scene.centrifugal) {
    case Centrifugal::projected:
      turning += radial;
      break;
    case Centrifugal::inward:
      steady -= radial;
      break;
    case Centrifugal::outward:
      steady += radial;
      break;
  }
  if (scene.pull_rotates) {
    turning -= std::polar(1.0, scene.pull_phase) * scene.pull;
  } else {
    steady -= scene.pull;
  }
  double swing = std::abs(turning);
  if (scene.disturbance_frequency > 0) {
    swing += std::abs(scene.disturbance);
  } else {
    steady += scene.disturbance * std::cos(scene.disturbance_phase);
  }
  return {std::abs(steady), swing};
}

std::optional<double> release_speed(const Scene& scene) {
  constexpr double growth = 1.01;
  double held = 0;
  if (excess(scene, held) > 0) return 0;
  double free = 1e-3;
  while (!(excess(scene, free) > 0)) {
    held = free;
    free *= growth;
    if (free > fastest_plate) return std::nullopt;
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (held + free) / 2;
    (excess(scene, middle) > 0 ? free : held) = middle;
  }
  return free;
}

double thrown_speed(const Scene& scene, double omega) {
  const AppliedForce force = applied_force(scene, omega);
  const double left = force.steady + force.swing - scene.friction * scene.normal_force;
  const double clearance = scene.wall_upper - scene.wall_lower;
  return left > 0 ? std::sqrt(2 * left * clearance / scene.mass) : 0;
}

}  // namespace ricochet::carrier_track::inline scene
