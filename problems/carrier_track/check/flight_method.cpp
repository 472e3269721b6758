#include "problems/carrier_track/check/flight_method.h"

#include <algorithm>
#include <numbers>

#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

ProfilePlate::Plate ProfilePlate::plate(double time) const {
  const auto next =
      std::find_if(knots.begin(), knots.end(), [&](const Knot& knot) { return time < knot.time; });
  if (next == knots.begin()) {
    return {next->alpha + next->omega * (time - next->time), next->omega, 0};
  }
  const Knot& last = *(next - 1);
  const double since = time - last.time;
  const double slope =
      next == knots.end() ? 0.0 : (next->omega - last.omega) / (next->time - last.time);
  return {last.alpha + since * (last.omega + 0.5 * slope * since), last.omega + slope * since,
          slope};
}

double ProfilePlate::applied(double time) const {
  const auto [alpha, omega, slope] = plate(time);
  return steady + square * omega * omega +
         (cosine + square_cosine * omega * omega) * std::cos(alpha) +
         (sine - slider * slope) * std::sin(alpha);
}

double ProfilePlate::applied_rate(double time) const {
  const auto [alpha, omega, slope] = plate(time);
  return 2 * square * omega * slope + 2 * square_cosine * omega * slope * std::cos(alpha) -
         (cosine + square_cosine * omega * omega) * omega * std::sin(alpha) +
         (sine - slider * slope) * omega * std::cos(alpha);
}

double ProfilePlate::strongest() const {
  double bound = 0;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const double omega = knots[k].omega;
    const double slope =
        k > 0 ? (omega - knots[k - 1].omega) / (knots[k].time - knots[k - 1].time) : 0.0;
    const double largest = std::max(omega, k > 0 ? knots[k - 1].omega : 0.0);
    bound = std::max(bound, std::abs(steady) + std::abs(cosine) + std::abs(sine - slider * slope) +
                                (std::abs(square) + std::abs(square_cosine)) * largest * largest);
  }
  return bound;
}

double Forces::strongest() const {
  return std::abs(steady) + std::abs(turning) + profile.strongest() + std::abs(disturbance);
}

double Forces::shortest_period() const {
  double plate = 0;
  for (const auto& knot : profile.knots) plate = std::max(plate, knot.omega);
  const double fastest =
      std::max(turning != 0 ? omega : 0.0, disturbance != 0 ? disturbance_frequency : 0.0);
  return 2 * std::numbers::pi / std::max(plate, fastest);
}

namespace {

ProfilePlate profile_of(const Scene& scene) {
  ProfilePlate plate;
  const double centrifugal = scene.centrifugal_mass_radius / scene.mass;
  plate.slider = scene.slider_mass_radius / scene.mass;
  plate.square_cosine = -plate.slider;
  if (scene.pull_rotates) {
    plate.cosine = -scene.pull / scene.mass * std::cos(scene.pull_phase);
    plate.sine = scene.pull / scene.mass * std::sin(scene.pull_phase);
  } else {
    plate.steady = -scene.pull / scene.mass;
  }
  if (scene.centrifugal == Centrifugal::projected) plate.square_cosine += centrifugal;
  if (scene.centrifugal == Centrifugal::inward) plate.square = -centrifugal;
  if (scene.centrifugal == Centrifugal::outward) plate.square = centrifugal;
  double alpha = scene.phase + scene.profile.front().omega * scene.profile.front().time;
  for (const auto& [time, omega] : scene.profile) {
    if (!plate.knots.empty()) {
      const auto& last = plate.knots.back();
      alpha += (time - last.time) * 0.5 * (last.omega + omega);
    }
    plate.knots.push_back({time, alpha, omega});
  }
  return plate;
}

}  // namespace

Forces forces_of(const Scene& scene) {
  Forces forces;
  const double square = scene.omega * scene.omega;
  const double centrifugal = scene.centrifugal_mass_radius * square / scene.mass;
  const double pull = scene.pull / scene.mass;
  double cosine = -scene.slider_mass_radius * square / scene.mass;
  double sine = 0;
  if (scene.pull_rotates) {
    cosine -= pull * std::cos(scene.pull_phase);
    sine = pull * std::sin(scene.pull_phase);
  } else {
    forces.steady = -pull;
  }
  if (scene.centrifugal == Centrifugal::projected) cosine += centrifugal;
  if (scene.centrifugal == Centrifugal::inward) forces.steady -= centrifugal;
  if (scene.centrifugal == Centrifugal::outward) forces.steady += centrifugal;
  forces.turning = std::hypot(cosine, sine);
  if (!scene.profile.empty()) {
    forces.profile = profile_of(scene);
    forces.steady = forces.turning = 0;
  }
  forces.omega = scene.omega;
  forces.phase = scene.phase - std::atan2(sine, cosine);
  forces.disturbance = scene.disturbance / scene.mass;
  forces.disturbance_frequency = scene.disturbance_frequency;
  forces.disturbance_phase = scene.disturbance_phase;
  forces.friction = scene.friction * scene.normal_force / scene.mass;
  return forces;
}

WallForce wall_force_of(const Scene& scene) {
  WallForce wall;
  wall.lower = scene.wall_lower;
  wall.upper = scene.wall_upper;
  wall.stiffness = scene.stiffness / scene.mass;
  wall.viscous = scene.contact_law == ContactLaw::kelvin_voigt;
  wall.exponent = wall.viscous ? 1 : scene.contact_exponent;
  const double unit = wall.viscous ? 2 * std::sqrt(wall.stiffness) : 1;
  wall.lower_damping = unit * damping_factor(scene.contact_law, lower_restitution(scene));
  wall.upper_damping = unit * damping_factor(scene.contact_law, upper_restitution(scene));
  wall.speed = scene.contact_speed.value_or(1);
  return wall;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
