#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {

/// The angle of the driver plate, its speed and omega', at a time [s].
struct Plate {
  double alpha, omega, slope;
};
inline Plate plate_at(const Scene& scene, double time) {
  const auto& knots = scene.profile;
  if (knots.empty()) return {scene.phase + scene.omega * time, scene.omega, 0};
  Plate plate{scene.phase + std::min(time, knots[0].time) * knots[0].omega, knots[0].omega, 0};
  for (std::size_t k = 1; k < knots.size() && time > knots[k - 1].time; ++k) {
    const double pace = (knots[k].omega - knots[k - 1].omega) / (knots[k].time - knots[k - 1].time);
    const double passed = std::min(time, knots[k].time) - knots[k - 1].time;
    plate.alpha += passed * (knots[k - 1].omega + pace * passed / 2);
    plate.omega = knots[k - 1].omega + pace * passed;
    plate.slope = time < knots[k].time ? pace : 0;
  }
  plate.alpha += std::max(0.0, time - knots.back().time) * plate.omega;
  return plate;
}

/// Force [N] of equation (31) on a body, but for contact and friction, straight from the formula.
inline double force_of_plate(const Scene& scene, double time) {
  const auto [alpha, omega, slope] = plate_at(scene, time);
  double force = -scene.pull * (scene.pull_rotates ? std::cos(alpha + scene.pull_phase) : 1);
  const double out[] = {std::cos(alpha), -1, 1};  // of Centrifugal
  force += scene.centrifugal_mass_radius * omega * omega * out[static_cast<int>(scene.centrifugal)];
  force -= scene.slider_mass_radius * (slope * std::sin(alpha) + omega * omega * std::cos(alpha));
  return force +
         scene.disturbance * std::cos(scene.disturbance_frequency * time + scene.disturbance_phase);
}

/// Force [N] of equation (22), the same.
inline double force_across(const Scene& scene, double time) {
  const double sine = std::sin(scene.omega * time + scene.phase);
  const double turned = std::sin(scene.omega * time + scene.phase + scene.pull_phase);
  return scene.across->pull + (scene.pull_rotates ? scene.pull * turned : 0.0) +
         scene.slider_mass_radius * scene.omega * scene.omega * sine;
}

/// A slow reference that shares nothing with the models but the scene: long double, fixed steps
/// [s], and within each step a constant force, that of its middle, under which the body moves on
/// parabolas from event to event. Its error falls with the square of the step. In two directions it
/// takes its conventions for friction and impacts from the words of planar_model.h.
class BruteForce {
 public:
  std::vector<Impact> impacts;  ///< in x
  double position, velocity;    ///< of x, at the end

  BruteForce(const Scene& scene, double step)
      : mu_(scene.friction), steady_(scene.normal_force / scene.mass) {
    const bool planar = scene.fidelity == Fidelity::planar;
    sides_.push_back(side_of(scene));
    if (planar) sides_.push_back(side_of(*scene.across));
    if (scene.contact_friction) {
      const long double kept = std::sqrt((1.0L - mu_) / (1.0L + mu_));
      sides_[0].restitution_lower *= kept;
      sides_[0].restitution_upper *= kept;
    }
    long double window = 0;
    if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
      window = 2 * std::numbers::pi_v<long double> * turns->count / scene.omega;
    } else {
      window = std::get<Seconds>(scene.window).count;
    }
    const auto steps = static_cast<long>(std::ceil(window / step));
    const long double h = window / steps;
    for (long k = 0; k < steps; ++k) {
      const auto middle = static_cast<double>((k + 0.5L) * h);
      sides_[0].push = force_of_plate(scene, middle) / scene.mass;
      if (planar) sides_[1].push = force_across(scene, middle) / scene.mass;
      for (long double left = h; left > 0;) left = advance((k + 1) * h, left);
    }
    position = static_cast<double>(sides_[0].position);
    velocity = static_cast<double>(sides_[0].velocity);
  }

 private:
  static constexpr long double never = std::numeric_limits<long double>::infinity();

  /// A body slower than this [m/s] that has just struck a wall stays there if it is pressed. Hops
  /// much slower are lost in the rounding of a position of some millimetres.
  static constexpr long double standstill = 5e-10L;

  /// One direction of the motion.
  struct Side {
    long double lower, upper, restitution_lower, restitution_upper, position, velocity;
    long double push = 0;  // acceleration by the applied forces
    int way = 0;           // direction in which the body moves or sets out, 0 if it is held
    long double speed = 0, gain = 0, strike = never, turn = never;  // that way; times of events

    /// Acceleration into the wall that the body rests on, 0 if it does not.
    long double press() const {
      if (velocity != 0) return 0;
      if (position == upper) return std::max(push, 0.0L);
      if (position == lower) return std::max(-push, 0.0L);
      return 0;
    }

    /// Looks for the next events.
    void look_ahead(long double friction) {
      way = velocity > 0 ? 1 : velocity < 0 ? -1 : 0;
      if (velocity == 0 && push > friction && position < upper) way = 1;
      if (velocity == 0 && push < -friction && position > lower) way = -1;
      speed = way * velocity;
      gain = way * push - friction;
      strike = turn = never;
      if (way == 0) return;
      strike = arrival(way * ((way > 0 ? upper : lower) - position));
      if (gain < 0) turn = -speed / gain;
    }

    /// When a body at `speed` >= 0 that gains `gain` has gone `distance`.
    long double arrival(long double distance) const {
      if (distance <= 0) return 0;
      const long double square = speed * speed + 2 * gain * distance;
      const long double denominator = square < 0 ? 0 : speed + std::sqrt(square);
      return denominator > 0 ? 2 * distance / denominator : never;
    }
  };

  template <class Direction>
  static Side side_of(const Direction& d) {
    return {d.wall_lower,        d.wall_upper,     d.restitution_lower,
            d.restitution_upper, d.start_position, d.start_velocity};
  }

  /// Goes on to the next event. Returns what is then left of `left`, the time until `end`.
  long double advance(long double end, long double left) {
    long double t = left;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const long double press = sides_.size() == 2 ? sides_[1 - i].press() : 0;
      sides_[i].look_ahead(mu_ * (steady_ + press));
      t = std::min({t, sides_[i].strike, sides_[i].turn});
    }
    left -= t;
    std::array<long double, 2> impulse{};
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      Side& side = sides_[i];
      if (side.way == 0) continue;
      const long double approach = side.speed + side.gain * t;
      side.position += side.way * t * (side.speed + side.gain * t / 2);
      side.velocity = t == side.turn ? 0 : side.way * approach;
      if (t != side.strike) continue;
      const bool up = side.way > 0;
      if (i == 0) {
        impacts.push_back({static_cast<double>(end - left), up ? Wall::upper : Wall::lower,
                           static_cast<double>(approach)});
      }
      const long double e = up ? side.restitution_upper : side.restitution_lower;
      side.position = up ? side.upper : side.lower;
      side.velocity = e * approach > standstill ? -side.way * e * approach : 0;
      impulse[i] = (1 + e) * approach;
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const long double speed = std::abs(sides_[i].velocity);
      sides_[i].velocity =
          std::copysign(std::max(speed - mu_ * impulse[1 - i], 0.0L), sides_[i].velocity);
    }
    return left;
  }

  long double mu_, steady_;
  std::vector<Side> sides_;
};

/// The impacts that are faster than a speed [m/s].
inline std::vector<Impact> faster(std::vector<Impact> impacts, double speed) {
  std::erase_if(impacts, [&](const Impact& impact) { return !(impact.speed > speed); });
  return impacts;
}

}  // namespace ricochet::carrier_track
