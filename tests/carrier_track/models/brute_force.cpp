#include "tests/carrier_track/models/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr long double never = std::numeric_limits<long double>::infinity();

/// A body slower than this [m/s] that has just struck a wall stays there if it is pressed. Hops
/// much slower are lost in the rounding of a position of some millimetres.
constexpr long double standstill = 5e-10L;

struct Body {
  long double position, velocity;
};

/// First time at which a body that starts at `speed` >= 0 and gains `gain` has gone `distance`.
long double arrival(long double distance, long double speed, long double gain) {
  if (distance <= 0) return 0;
  const long double square = speed * speed + 2 * gain * distance;
  if (square < 0) return never;
  const long double denominator = speed + std::sqrt(square);
  return denominator > 0 ? 2 * distance / denominator : never;
}

class Stepper {
 public:
  explicit Stepper(const Scene& scene)
      : scene_(scene),
        friction_(static_cast<long double>(scene.friction) * scene.normal_force / scene.mass),
        body_{scene.start_position, scene.start_velocity} {}

  /// Lets a constant acceleration act from `start` on for `step` [s].
  void advance(long double start, long double step, long double push) {
    long double left = step;
    while (left > 0) {
      const int direction = way(push);
      if (direction == 0) return;
      const long double gain = direction * push - friction_;
      const long double speed = direction * body_.velocity;
      const long double wall = direction > 0 ? scene_.wall_upper : scene_.wall_lower;
      const long double strike = arrival(direction * (wall - body_.position), speed, gain);
      const long double turn = gain < 0 ? -speed / gain : never;
      const long double t = std::min({left, strike, turn});
      left -= t;
      if (t == strike) {
        hit(start + step - left, direction, speed + gain * t);
      } else {
        body_.position += t * (body_.velocity + direction * gain * t / 2);
        body_.velocity = t == turn ? 0 : body_.velocity + direction * gain * t;
      }
    }
  }

  BruteForce result() const {
    return {impacts_, static_cast<double>(body_.position), static_cast<double>(body_.velocity)};
  }

 private:
  /// Direction in which the body moves or sets out, 0 if it is held.
  int way(long double push) const {
    if (body_.velocity != 0) return body_.velocity > 0 ? 1 : -1;
    if (push > friction_ && body_.position < scene_.wall_upper) return 1;
    if (push < -friction_ && body_.position > scene_.wall_lower) return -1;
    return 0;
  }

  void hit(long double time, int direction, long double speed) {
    const Wall wall = direction > 0 ? Wall::upper : Wall::lower;
    impacts_.push_back({static_cast<double>(time), wall, static_cast<double>(speed)});
    body_.position = direction > 0 ? scene_.wall_upper : scene_.wall_lower;
    long double rebound =
        speed * (direction > 0 ? scene_.restitution_upper : scene_.restitution_lower);
    if (scene_.contact_friction) {
      rebound *= std::sqrt((1.0L - scene_.friction) / (1.0L + scene_.friction));
    }
    body_.velocity = rebound > standstill ? -direction * rebound : 0;
  }

  const Scene& scene_;
  long double friction_;
  Body body_;
  std::vector<Impact> impacts_;
};

}  // namespace

double force_of_plate(const Scene& scene, double time) {
  const double omega = scene.omega;
  const double cosine = std::cos(omega * time + scene.phase);
  const double turned = std::cos(omega * time + scene.phase + scene.pull_phase);
  double force = -scene.pull * (scene.pull_rotates ? turned : 1);
  const double centrifugal = scene.centrifugal_mass_radius * omega * omega;
  if (scene.centrifugal == Centrifugal::projected) force += centrifugal * cosine;
  if (scene.centrifugal == Centrifugal::inward) force -= centrifugal;
  if (scene.centrifugal == Centrifugal::outward) force += centrifugal;
  force -= scene.slider_mass_radius * omega * omega * cosine;
  force +=
      scene.disturbance * std::cos(scene.disturbance_frequency * time + scene.disturbance_phase);
  return force;
}

BruteForce brute_force(const Scene& scene, double step) {
  long double window = 0;
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    window = 2 * std::numbers::pi_v<long double> * turns->count / scene.omega;
  } else {
    window = std::get<Seconds>(scene.window).count;
  }
  const auto steps = static_cast<long>(std::ceil(window / step));
  const long double exact_step = window / steps;
  Stepper stepper(scene);
  for (long k = 0; k < steps; ++k) {
    const long double start = k * exact_step;
    stepper.advance(
        start, exact_step,
        force_of_plate(scene, static_cast<double>(start + exact_step / 2)) / scene.mass);
  }
  return stepper.result();
}

}  // namespace ricochet::carrier_track
