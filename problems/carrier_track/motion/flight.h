#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "problems/carrier_track/motion/harmonic.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline flight {

template <class Scalar>
struct Motion {
  Scalar position;      ///< [m]
  Scalar velocity;      ///< [m/s]
  Scalar acceleration;  ///< [m/s^2]
};

/// Motion after a time t [s] under a steady acceleration [m/s^2].
template <class Scalar>
Motion<Scalar> fall(const Scalar& position, const Scalar& velocity, const Scalar& steady,
                    const Scalar& t) {
  Motion<Scalar> m;
  if constexpr (Dual<Scalar>) {
    const auto& time = t.a;
    const auto inner = fall(position.a, velocity.a, steady.a, time);
    m.position.a = inner.position;
    m.velocity.a = inner.velocity;
    m.position.v =
        position.v + velocity.v * time + t.v * inner.velocity + steady.v * scaled(time * time, 0.5);
    m.velocity.v = velocity.v + steady.v * time + t.v * steady.a;
    m.acceleration = steady;
  } else {
    m = {position + t * (velocity + steady * t * constant<Scalar>(0.5)), velocity + steady * t,
         steady};
  }
  return m;
}

/// The acceleration and jerk of a path's forces.
struct AppliedForce {
  double acceleration;  ///< [m/s^2]
  double jerk;          ///< [m/s^3]
};

/// Bounds on the forces of a path.
struct ForceBounds {
  double acceleration = 0;   ///< [m/s^2], the sum of the magnitudes
  double jerk = 0;           ///< [m/s^3]
  double snap = 0;           ///< [m/s^4]
  double shortest_step = 0;  ///< [s]; in a shorter time the forces change by rounding only
};

/// Free motion in closed form under x'' = steady + sum of harmonics, from a given start.
/// The constant part holds friction, so a flight is valid only while the velocity keeps its sign.
template <class Scalar>
struct Flight {
  Scalar position;                           ///< [m] at its start
  Scalar velocity;                           ///< [m/s] at its start
  Scalar steady;                             ///< [m/s^2]
  std::array<Harmonic<Scalar>, 2> harmonic;  ///< driver plate, disturbance
  int harmonics = 2;                         ///< number of harmonics that act

  /// Exact up to rounding at any t [s] from the flight's start. If `turned` is given, it receives
  /// the harmonics at that time.
  Motion<Scalar> at(const Scalar& t, std::array<Harmonic<Scalar>, 2>* turned = nullptr) const {
    Motion<Scalar> m = fall(position, velocity, steady, t);
    for (int i = 0; i < harmonics; ++i) {
      const auto& h = acting(i);
      const Swung<Scalar> by = swung(h, t);
      m.position += by.position;
      m.velocity += by.velocity;
      m.acceleration += by.cosine;
      if (turned != nullptr) {
        (*turned)[static_cast<std::size_t>(i)] = {by.cosine, by.sine, h.frequency};
      }
    }
    return m;
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) { position += by; }

  /// The forces at any t >= 0 [s], more accurate than at() for long t.
  AppliedForce applied_at(double t) const {
    AppliedForce push{value(steady), 0};
    for (int i = 0; i < harmonics; ++i) {
      const Harmonic<double> h = plain().acting(i);
      const double c = std::cos(h.frequency * t);
      const double s = std::sin(h.frequency * t);
      push.acceleration += h.cosine * c - h.sine * s;
      push.jerk -= h.frequency * (h.cosine * s + h.sine * c);
    }
    return push;
  }

  /// Adds `factor` times the forces of a flight whose harmonics have the same frequencies.
  void add(double factor, const Flight& other) {
    const Scalar by = constant<Scalar>(factor);
    steady += by * other.steady;
    for (int i = 0; i < other.harmonics; ++i) {
      auto& h = harmonic[static_cast<std::size_t>(i)];
      h.cosine += by * other.acting(i).cosine;
      h.sine += by * other.acting(i).sine;
    }
    harmonics = harmonics > other.harmonics ? harmonics : other.harmonics;
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) { steady += by; }

  /// Lets `t` [s] pass: moves the start of the same flight.
  void advance(const Scalar& t) {
    const Motion<Scalar> m = at(t, &harmonic);
    position = m.position;
    velocity = m.velocity;
  }

  /// Lets a time [s] pass whose value is 0 and whose derivatives are given.
  template <class Tangent>
  void shift_time_derivative(const Tangent& t) requires Dual<Scalar> {
    position.v += t * velocity.a;
    velocity.v += t * acceleration().a;
    for (int i = 0; i < harmonics; ++i) {
      auto& h = harmonic[static_cast<std::size_t>(i)];
      h.cosine.v -= t * (h.frequency.a * h.sine.a);
      h.sine.v += t * (h.frequency.a * h.cosine.a);
    }
  }

  /// The second derivative of the position [m/s^2] at the start of the flight.
  Scalar acceleration() const {
    Scalar sum = steady;
    for (int i = 0; i < harmonics; ++i) sum += acting(i).cosine;
    return sum;
  }

  /// The third derivative of the position [m/s^3] at the start of the flight.
  Scalar jerk() const {
    Scalar sum = constant<Scalar>(0.0);
    for (int i = 0; i < harmonics; ++i) sum -= acting(i).frequency * acting(i).sine;
    return sum;
  }

  /// The fourth derivative of the position [m/s^4] at the start of the flight.
  Scalar snap() const {
    Scalar sum = constant<Scalar>(0.0);
    for (int i = 0; i < harmonics; ++i) {
      sum -= acting(i).frequency * acting(i).frequency * acting(i).cosine;
    }
    return sum;
  }

  /// Sum of the magnitudes that make up acceleration() [m/s^2]: what its rounding is relative to.
  double size() const {
    double sum = std::abs(value(steady));
    for (int i = 0; i < harmonics; ++i) sum += std::abs(value(acting(i).cosine));
    return sum;
  }

  /// A bound over all time on the jerk [m/s^3], at most sqrt(2) times the sum of the amplitudes.
  double jerk_bound() const {
    double bound = 0;
    for (int i = 0; i < harmonics; ++i) {
      const auto& h = acting(i);
      bound += value(h.frequency) * (std::abs(value(h.cosine)) + std::abs(value(h.sine)));
    }
    return bound;
  }

  /// Bounds up to a time [s] from the start. For two harmonics of nearly the same frequency that
  /// almost cancel, the bounds are far below the sum of the single bounds; otherwise the search
  /// would need many short steps.
  ForceBounds bounds(double until) const {
    ForceBounds bounds;
    bounds.acceleration = std::abs(value(steady));
    double fastest = 0;
    for (int i = 0; i < harmonics; ++i) {
      const auto [amplitude, frequency] = swing(i);
      bounds.acceleration += amplitude;
      bounds.jerk += amplitude * frequency;
      bounds.snap += amplitude * frequency * frequency;
      if (amplitude > 0) fastest = std::fmax(fastest, frequency);
    }
    bounds.shortest_step = fastest > 0 ? 1e-8 / fastest : 0.0;
    if (harmonics == 2) {
      bounds.jerk = std::fmin(bounds.jerk, together(1, until));
      bounds.snap = std::fmin(bounds.snap, together(2, until));
    }
    return bounds;
  }

  /// The first Taylor coefficients of the acceleration at the start. They give it to full accuracy
  /// up to `reach` [s].
  struct Taylor {
    std::array<double, 7> coefficient;
    double reach;
  };
  Taylor taylor() const {
    Taylor taylor{{value(steady)}, 0};
    double fastest = 0;
    for (int i = 0; i < harmonics; ++i) {
      const double frequency = value(acting(i).frequency);
      double even = value(acting(i).cosine);
      double odd = -value(acting(i).sine) * frequency;
      for (std::size_t k = 0; k < taylor.coefficient.size(); k += 2) {
        taylor.coefficient[k] += even;
        if (k + 1 < taylor.coefficient.size()) taylor.coefficient[k + 1] += odd;
        const auto order = static_cast<double>(k);
        even *= -frequency * frequency / ((order + 1) * (order + 2));
        odd *= -frequency * frequency / ((order + 2) * (order + 3));
      }
      fastest = std::fmax(fastest, frequency);
    }
    taylor.reach = 0.02 / fastest;
    return taylor;
  }

  /// `least`: a lower bound on the speed in `direction` over the next `time` [s]. `mean`: the value
  /// about which the speed oscillates, without the steady acceleration. Both in [m/s].
  struct Speeds {
    double least, mean;
  };
  Speeds speeds(int direction, double time) const {
    const double start = direction * value(velocity);
    Speeds speeds{start + std::fmin(direction * value(steady), 0.0) * time, start};
    for (int i = 0; i < harmonics; ++i) {
      const auto [amplitude, frequency] = swing(i);
      const double sine = direction * value(acting(i).sine);
      const double drop = (amplitude + sine) / frequency;
      const bool slow = !(drop < amplitude * time);  // NaN if frequency is 0
      speeds.least -= slow ? amplitude * time : drop;
      if (!slow) speeds.mean -= sine / frequency;
    }
    return speeds;
  }

  /// The flight in the arithmetic that the dual is made of.
  auto inner() const requires Dual<Scalar> {
    Flight<Inner<Scalar>> result{position.a, velocity.a, steady.a, {}, harmonics};
    for (std::size_t i = 0; i < harmonic.size(); ++i) {
      result.harmonic[i] = {harmonic[i].cosine.a, harmonic[i].sine.a, harmonic[i].frequency.a};
    }
    return result;
  }

  auto inner_acceleration() const requires Dual<Scalar> { return acceleration().a; }

  /// The plain values, for searching events.
  Flight<double> plain() const {
    // The copy below would slow a simulation of plain numbers down by about 6 %.
    if constexpr (std::is_same_v<Scalar, double>) return *this;
    Flight<double> result{value(position), value(velocity), value(steady), {}, harmonics};
    for (std::size_t i = 0; i < harmonic.size(); ++i) {
      result.harmonic[i] = {value(harmonic[i].cosine), value(harmonic[i].sine),
                            value(harmonic[i].frequency)};
    }
    return result;
  }

  struct Swing {
    double amplitude, frequency;
  };
  Swing swing(int i) const {
    const double cosine = value(acting(i).cosine);
    const double sine = value(acting(i).sine);
    return {std::sqrt(cosine * cosine + sine * sine), value(acting(i).frequency)};
  }

  /// A bound up to a time on the first or second derivative of the sum of both harmonics, taken as
  /// one slowly changing harmonic.
  double together(int order, double until) const {
    double cosine = 0;
    double sine = 0;
    double drift = 0;
    for (int i = 0; i < 2; ++i) {
      const auto [amplitude, frequency] = swing(i);
      const double factor = order == 1 ? frequency : frequency * frequency;
      cosine += factor * value(acting(i).cosine);
      sine += factor * value(acting(i).sine);
      const double apart = std::abs(frequency - value(acting(0).frequency));
      if (apart > 0) drift = factor * amplitude * std::fmin(2.0, apart * until);
    }
    return std::sqrt(cosine * cosine + sine * sine) + drift;
  }

  const Harmonic<Scalar>& acting(int i) const { return harmonic[static_cast<std::size_t>(i)]; }
};

}  // namespace ricochet::carrier_track::inline flight
