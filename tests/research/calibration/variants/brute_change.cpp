#include "tests/research/calibration/variants/brute_change.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/scene/window.h"
#include "ricochet/recording.h"

namespace ricochet::studies::variants {
namespace {

using namespace carrier_track;

constexpr long double forever = std::numeric_limits<long double>::infinity();
constexpr long double too_slow_to_hop = 5e-10L;  // [m/s]

double force_along_x(const Scene& scene, double time) {
  const double alpha = scene.omega * time + scene.phase;
  const double square = scene.omega * scene.omega;
  double force = -scene.pull * (scene.pull_rotates ? std::cos(alpha + scene.pull_phase) : 1);
  if (scene.centrifugal == Centrifugal::projected) {
    force += scene.centrifugal_mass_radius * square * std::cos(alpha);
  }
  if (scene.centrifugal == Centrifugal::inward) force -= scene.centrifugal_mass_radius * square;
  if (scene.centrifugal == Centrifugal::outward) force += scene.centrifugal_mass_radius * square;
  force -= scene.slider_mass_radius * square * std::cos(alpha);
  return force +
         scene.disturbance * std::cos(scene.disturbance_frequency * time + scene.disturbance_phase);
}

struct Particle {
  long double position, velocity;
};

/// First time at which a body that starts at `speed` >= 0 and gains `gain` has gone `distance`.
long double time_to_go(long double distance, long double speed, long double gain) {
  if (distance <= 0) return 0;
  const long double square = speed * speed + 2 * gain * distance;
  if (square < 0) return forever;
  const long double denominator = speed + std::sqrt(square);
  return denominator > 0 ? 2 * distance / denominator : forever;
}

int way_of(const Scene& scene, const Particle& body, long double push, long double friction) {
  if (body.velocity != 0) return body.velocity > 0 ? 1 : -1;
  if (push > friction && body.position < scene.wall_upper) return 1;
  if (push < -friction && body.position > scene.wall_lower) return -1;
  return 0;
}

long double rebound_of(const Scene& scene, const BruteChanges& changes, int direction,
                       long double speed) {
  long double e = direction > 0 ? scene.restitution_upper : scene.restitution_lower;
  if (changes.restitution) {
    e = changes.restitution(static_cast<double>(speed), static_cast<double>(e));
  }
  if (scene.contact_friction) e *= std::sqrt((1.0L - scene.friction) / (1.0L + scene.friction));
  return speed * e > too_slow_to_hop ? speed * e : 0;
}

}  // namespace

std::vector<Impact> brute_change(const Scene& scene, const BruteChanges& changes, double step) {
  std::vector<Impact> impacts;
  Particle body{scene.start_position, scene.start_velocity};
  const auto steps = std::lround(duration_of(scene) / step);
  for (long k = 0; k < steps; ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * step;
    double force = force_along_x(scene, middle);
    if (changes.further_force) force += changes.further_force(middle);
    const double normal = changes.normal_force ? changes.normal_force(middle) : scene.normal_force;
    const long double push = force / scene.mass;
    const long double friction = scene.friction * normal / scene.mass;
    long double left = step;
    while (left > 0) {
      const int direction = way_of(scene, body, push, friction);
      if (direction == 0) break;
      const long double gain = direction * push - friction;
      const long double speed = direction * body.velocity;
      const long double wall = direction > 0 ? scene.wall_upper : scene.wall_lower;
      const long double strike = time_to_go(direction * (wall - body.position), speed, gain);
      const long double turn = gain < 0 ? -speed / gain : forever;
      const long double t = std::min({left, strike, turn});
      left -= t;
      if (t != strike) {
        body.position += t * (body.velocity + direction * gain * t / 2);
        body.velocity = t == turn ? 0 : body.velocity + direction * gain * t;
        continue;
      }
      const long double approach = speed + gain * t;
      impacts.push_back({static_cast<double>((k + 1) * static_cast<long double>(step) - left),
                         direction > 0 ? Wall::upper : Wall::lower, static_cast<double>(approach)});
      body = {wall, -direction * rebound_of(scene, changes, direction, approach)};
    }
  }
  return impacts;
}

}  // namespace ricochet::studies::variants
