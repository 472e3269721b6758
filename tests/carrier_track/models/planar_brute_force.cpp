#include "tests/carrier_track/models/planar_brute_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr long double never = std::numeric_limits<long double>::infinity();

/// A body slower than this [m/s] that has just struck a wall stays there; see brute_force.cpp.
constexpr long double standstill = 5e-10L;

struct Side {
  long double lower, upper, restitution_lower, restitution_upper, position, velocity;

  long double wall(int direction) const { return direction > 0 ? upper : lower; }
  long double restitution(int direction) const {
    return direction > 0 ? restitution_upper : restitution_lower;
  }
  /// Acceleration into the wall that the body rests on, 0 if it does not.
  long double press(long double push) const {
    if (velocity != 0) return 0;
    if (position == upper) return std::max(push, 0.0L);
    if (position == lower) return std::max(-push, 0.0L);
    return 0;
  }
  /// Direction in which the body moves or sets out, 0 if it is held.
  int way(long double push, long double friction) const {
    if (velocity != 0) return velocity > 0 ? 1 : -1;
    if (push > friction && position < upper) return 1;
    if (push < -friction && position > lower) return -1;
    return 0;
  }
};

template <class Direction>
Side side_of(const Direction& d) {
  return {d.wall_lower,        d.wall_upper,     d.restitution_lower,
          d.restitution_upper, d.start_position, d.start_velocity};
}

/// Time until a body at `speed` >= 0 that gains `gain` has gone `distance`.
long double arrival(long double distance, long double speed, long double gain) {
  if (distance <= 0) return 0;
  const long double square = speed * speed + 2 * gain * distance;
  const long double denominator = square < 0 ? 0 : speed + std::sqrt(square);
  return denominator > 0 ? 2 * distance / denominator : never;
}

}  // namespace

double applied_force_across(const Scene& scene, double time) {
  const double sine = std::sin(scene.omega * time + scene.phase);
  const double turned = std::sin(scene.omega * time + scene.phase + scene.pull_phase);
  return scene.across->pull + (scene.pull_rotates ? scene.pull * turned : 0.0) +
         scene.slider_mass_radius * scene.omega * scene.omega * sine;
}

BruteForce planar_brute_force(const Scene& scene, double step) {
  const long double window = duration_of(scene);
  const auto steps = static_cast<long>(std::ceil(window / step));
  const long double h = window / steps;
  const long double mu = scene.friction;
  std::array<Side, 2> sides = {side_of(scene), side_of(*scene.across)};
  BruteForce result{};
  for (long k = 0; k < steps; ++k) {
    const auto middle = static_cast<double>((k + 0.5L) * h);
    const std::array<long double, 2> push = {force_of_plate(scene, middle) / scene.mass,
                                             applied_force_across(scene, middle) / scene.mass};
    for (long double left = h; left > 0;) {
      std::array<int, 2> way{};
      std::array<long double, 2> gain{}, strike{}, turn{};
      long double t = left;
      for (std::size_t i = 0; i < 2; ++i) {
        const Side& side = sides[i];
        const long double friction =
            mu * (scene.normal_force / scene.mass + sides[1 - i].press(push[1 - i]));
        way[i] = side.way(push[i], friction);
        gain[i] = way[i] * push[i] - friction;
        strike[i] = turn[i] = never;
        if (way[i] == 0) continue;
        const long double speed = way[i] * side.velocity;
        strike[i] = arrival(way[i] * (side.wall(way[i]) - side.position), speed, gain[i]);
        if (gain[i] < 0) turn[i] = -speed / gain[i];
        t = std::min({t, strike[i], turn[i]});
      }
      left -= t;
      std::array<long double, 2> impulse{};
      for (std::size_t i = 0; i < 2; ++i) {
        Side& side = sides[i];
        if (way[i] == 0) continue;
        const long double speed = way[i] * side.velocity;
        side.position += way[i] * t * (speed + gain[i] * t / 2);
        side.velocity = t == turn[i] ? 0 : way[i] * (speed + gain[i] * t);
        if (t != strike[i]) continue;
        const long double approach = way[i] * side.velocity;
        const long double e = side.restitution(way[i]);
        if (i == 0) {
          result.impacts.push_back({static_cast<double>((k + 1) * h - left),
                                    way[i] > 0 ? Wall::upper : Wall::lower,
                                    static_cast<double>(approach)});
        }
        side.position = side.wall(way[i]);
        side.velocity = e * approach > standstill ? -way[i] * e * approach : 0;
        impulse[i] = (1 + e) * approach;
      }
      for (std::size_t i = 0; i < 2; ++i) {
        const long double speed = std::abs(sides[i].velocity);
        sides[i].velocity =
            std::copysign(std::max(speed - mu * impulse[1 - i], 0.0L), sides[i].velocity);
      }
    }
  }
  result.position = static_cast<double>(sides[0].position);
  result.velocity = static_cast<double>(sides[0].velocity);
  return result;
}

}  // namespace ricochet::carrier_track
