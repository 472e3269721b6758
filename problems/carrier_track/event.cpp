#include "problems/carrier_track/event.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ricochet::carrier_track {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Bounds over all time on what the harmonics of a flight can do.
struct Bounds {
  double acceleration = 0;   ///< [m/s^2], steady part included
  double jerk = 0;           ///< [m/s^3]
  double snap = 0;           ///< [m/s^4]
  double shortest_step = 0;  ///< [s], below which the forces do not change within rounding
};

Bounds bounds_of(const Flight<double>& flight) {
  Bounds bounds;
  bounds.acceleration = std::abs(flight.steady);
  double fastest = 0;
  const auto add = [&](double cosine, double sine, double frequency) {
    const double amplitude = std::sqrt(cosine * cosine + sine * sine);
    bounds.jerk += amplitude * frequency;
    bounds.snap += amplitude * frequency * frequency;
    if (amplitude > 0) fastest = std::max(fastest, frequency);
    return amplitude;
  };
  const auto& [plate, disturbance] = flight.harmonic;
  if (flight.harmonics == 2 && plate.frequency == disturbance.frequency) {
    // As one harmonic: two that all but cancel would have the search creep.
    add(plate.cosine + disturbance.cosine, plate.sine + disturbance.sine, plate.frequency);
    bounds.acceleration += std::abs(plate.cosine) + std::abs(plate.sine) +
                           std::abs(disturbance.cosine) + std::abs(disturbance.sine);
  } else {
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      bounds.acceleration += add(h.cosine, h.sine, h.frequency);
    }
  }
  bounds.shortest_step = fastest > 0 ? 1e-8 / fastest : 0.0;
  return bounds;
}

/// Smallest h > 0 with value + slope h - bound h^2 / 2 = 0, for value >= 0: no function with this
/// value and slope, whose second derivative is at least -bound, is negative before h.
double safe_step(double value, double slope, double bound) {
  const double root = std::sqrt(slope * slope + 2 * bound * value);
  if (slope < 0) return 2 * value / (root - slope);
  return bound > 0 ? (slope + root) / bound : infinity;
}

/// Motion seen in the direction of travel.
struct Travel {
  double distance, speed, acceleration;
};

class Traveller {
 public:
  Traveller(const Flight<double>& flight, int direction, std::int64_t& evaluations)
      : flight_(flight), direction_(direction), evaluations_(evaluations) {}

  Travel at(double time) const {
    ++evaluations_;
    const Motion<double> m = flight_.at(time);
    return {direction_ * (m.position - flight_.position), direction_ * m.velocity,
            direction_ * m.acceleration};
  }

  /// Where the flight starts.
  Travel start() const {
    double acceleration = flight_.steady;
    for (int i = 0; i < flight_.harmonics; ++i) {
      acceleration += flight_.harmonic[static_cast<std::size_t>(i)].cosine;
    }
    return {0, direction_ * flight_.velocity, direction_ * acceleration};
  }

  /// Time in [lower, upper] at which the distance reaches `ahead`, where it is monotone; `jerk`
  /// bounds the third derivative.
  double arrival(double ahead, double lower, double upper, Travel from, double jerk) const {
    double time = lower;
    for (int i = 0; i < 100 && upper - lower > 2 * epsilon * upper; ++i) {
      const double gap = ahead - from.distance;
      const double square = from.speed * from.speed + 2 * from.acceleration * gap;
      // The step of the local parabola; bisection where there is none or it leaves the bracket.
      const double speed = square >= 0 ? std::sqrt(square) : 0;  // at the wall
      double next = square >= 0 ? time + 2 * gap / (from.speed + speed) : infinity;
      double error = infinity;
      if (next > lower && next < upper) {
        const double step = std::abs(next - time);
        error = jerk * step * step * step / (6 * speed);
      } else {
        if (std::abs(next - time) <= 2 * epsilon * time) break;
        next = lower + 0.5 * (upper - lower);
      }
      const bool settled = error <= epsilon * next || std::abs(next - time) <= 2 * epsilon * next;
      time = next;
      if (settled) break;
      from = at(time);
      (from.distance < ahead ? lower : upper) = time;
    }
    return time;
  }

 private:
  const Flight<double>& flight_;
  double direction_;
  std::int64_t& evaluations_;
};

/// Most flights are short beside the period of their forces, and then bounds from the start alone
/// prove which event comes first and that it is the only root in reach; a few steps find it.
/// `jerk` bounds the third derivative.
class ShortFlight {
 public:
  ShortFlight(const Flight<double>& flight, int direction, double horizon,
              const Traveller& traveller)
      : traveller_(traveller), horizon_(horizon) {
    const Travel start = traveller.start();
    speed_ = start.speed;
    acceleration_ = start.acceleration;
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      jerk_bound_ += h.frequency * (std::abs(h.cosine) + std::abs(h.sine));
      size_ += std::abs(h.cosine);
    }
    size_ += std::abs(flight.steady);
    jerk_ = direction * flight.jerk();
  }

  /// Time of the turn, where it comes first for certain: speed <= v + a t + J t^2 / 2 crosses zero
  /// while the acceleration is still negative, and before the wall can be reached.
  std::optional<double> turn(double ahead) const {
    const double certain = acceleration_ * acceleration_ - 2 * jerk_bound_ * speed_;
    if (!(acceleration_ < -noise() && speed_ > 0 && certain > 0)) return std::nullopt;
    const double latest = 2 * speed_ / (std::sqrt(certain) - acceleration_);
    if (!(latest < horizon_ && 0.5 * speed_ * latest < ahead)) return std::nullopt;
    const double square = acceleration_ * acceleration_ - 2 * jerk_ * speed_;
    double time = 2 * speed_ / (std::sqrt(square) - acceleration_);
    for (int i = 0; i < steps; ++i) {
      const Travel m = traveller_.at(time);
      const double step = -m.speed / m.acceleration;
      time = std::min(time + step, latest);
      // Newton's next error is below J step^2 / (2 |a|).
      if (jerk_bound_ * step * step <= -2 * epsilon * m.acceleration * time) return time;
    }
    return std::nullopt;
  }

  /// Time of the wall, where it comes first for certain: the speed is at least v + a t - J t^2 / 2,
  /// which stays positive until the distance that follows from it is beyond the wall.
  std::optional<double> wall(double ahead) const {
    const double square = speed_ * speed_ + 2 * acceleration_ * ahead;
    if (!(square > 0 && speed_ >= 0 && speed_ + std::sqrt(square) > 0)) return std::nullopt;
    double time = 2 * ahead / (speed_ + std::sqrt(square));
    const double latest = 1.25 * time;
    const double slow = speed_ + latest * (acceleration_ - latest * jerk_bound_ / 2);
    const double near = latest * (speed_ + latest * (acceleration_ / 2 - latest * jerk_bound_ / 6));
    const bool accelerates = speed_ > 0 || acceleration_ > noise();
    if (!(slow > 0 && near > ahead && latest < horizon_ && accelerates)) return std::nullopt;
    // One Newton step on the cubic with the jerk at the start.
    const double miss = time * (speed_ + time * (acceleration_ / 2 + time * jerk_ / 6)) - ahead;
    time -= miss / (speed_ + time * (acceleration_ + time * jerk_ / 2));
    for (int i = 0; i < steps; ++i) {
      const Travel m = traveller_.at(time);
      const double gap = ahead - m.distance;
      const double left = m.speed * m.speed + 2 * m.acceleration * gap;
      if (!(left > 0 && m.speed > 0)) return std::nullopt;
      const double speed = std::sqrt(left);  // at the wall
      const double step = 2 * gap / (m.speed + speed);
      time = std::min(time + step, latest);
      // The parabola's next error is about J step^3 / (6 v).
      if (jerk_bound_ * std::abs(step * step * step) <= 6 * epsilon * speed * time) return time;
    }
    return std::nullopt;
  }

 private:
  static constexpr int steps = 6;
  /// An acceleration below this may be rounding.
  double noise() const { return 1e-9 * size_; }

  const Traveller& traveller_;
  double speed_;
  double acceleration_;
  double jerk_;
  double jerk_bound_ = 0;
  double size_ = 0;  // sum of the forces' magnitudes
  double horizon_;
};

}  // namespace

Event next_event(const Flight<double>& flight, int direction, double ahead, double horizon,
                 std::int64_t& evaluations) {
  if (ahead <= 0) return {EventKind::wall, 0, direction};
  const Traveller traveller(flight, direction, evaluations);
  const ShortFlight quick(flight, direction, horizon, traveller);
  if (const auto time = quick.turn(ahead)) return {EventKind::turn, *time, direction};
  if (const auto time = quick.wall(ahead)) return {EventKind::wall, *time, direction};
  const Bounds bounds = bounds_of(flight);
  Travel here = traveller.start();
  const double start_speed = here.speed;
  double time = 0;
  double patience = bounds.shortest_step;
  double step = safe_step(here.speed, here.acceleration, bounds.jerk);
  if (here.speed <= 0) {  // setting out from rest with the force just beyond friction
    const double jerk = direction * flight.jerk();
    if (jerk > 0) step = std::max(step, 3 * jerk / bounds.snap);
    step = std::max(step, bounds.shortest_step);
  }
  for (;;) {
    const double next = std::min(time + step, horizon);
    Travel there = traveller.at(next);
    if (there.distance >= ahead) {
      return {EventKind::wall, traveller.arrival(ahead, time, next, here, bounds.jerk), direction};
    }
    if (next >= horizon) return {EventKind::horizon, horizon, direction};
    const double noise = 4 * epsilon * (start_speed + bounds.acceleration * next);
    if (there.speed <= noise) {
      if (there.acceleration <= 0) return {EventKind::turn, next, direction};
      there.speed = std::max(there.speed, 0.0);
    }
    step = std::max(safe_step(there.speed, there.acceleration, bounds.jerk), epsilon * next);
    // A speed that stays lost in rounding is left behind by steps that double.
    patience = there.speed <= noise ? 2 * patience : bounds.shortest_step;
    if (there.speed <= noise) step = std::max(step, patience);
    time = next;
    here = there;
  }
}

Event next_departure(const Flight<double>& applied, double friction, bool may_rise, bool may_fall,
                     double horizon, std::int64_t& evaluations) {
  const Bounds bounds = bounds_of(applied);
  const double noise = 4 * epsilon * (bounds.acceleration + friction);
  const double slope_noise = 4 * epsilon * bounds.jerk;
  if (bounds.jerk <= 0) return {EventKind::horizon, horizon, 0};
  double time = 0;
  double patience = bounds.shortest_step;
  for (;;) {
    // The flight's derivatives at `time`, from its harmonics turned there.
    double push = applied.steady;
    double slope = 0;
    for (int i = 0; i < applied.harmonics; ++i) {
      const auto& h = applied.harmonic[static_cast<std::size_t>(i)];
      const double u = h.frequency * time;
      const double c = std::cos(u);
      const double s = std::sin(u);
      push += h.cosine * c - h.sine * s;
      slope -= h.frequency * (h.cosine * s + h.sine * c);
    }
    ++evaluations;
    double step = infinity;
    bool at_the_edge = false;
    for (const int direction : {+1, -1}) {
      if (direction > 0 ? !may_rise : !may_fall) continue;
      const double reserve = friction - direction * push;
      const double reserve_slope = -direction * slope;
      if (reserve <= noise && reserve_slope < -slope_noise) {
        return {EventKind::depart, time, direction};
      }
      step = std::min(step, safe_step(std::max(reserve, 0.0), reserve_slope, bounds.snap));
      at_the_edge = at_the_edge || reserve <= noise;
    }
    // A force that stays within rounding of the band's edge is left behind by steps that double.
    patience = at_the_edge ? 2 * patience : bounds.shortest_step;
    if (at_the_edge) step = std::max(step, patience);
    if (time >= horizon || step == infinity) return {EventKind::horizon, horizon, 0};
    time = std::min(time + std::max(step, epsilon * time), horizon);
  }
}

}  // namespace ricochet::carrier_track
