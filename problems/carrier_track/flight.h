#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "problems/carrier_track/scalar.h"

namespace ricochet::carrier_track {

/// c2 = (1 - cos u) / u^2 and c3 = (u - sin u) / u^3, the Stumpff functions of u^2. Everything that
/// a flight under harmonic forces needs follows from them without cancellation, u = 0 included.
template <class Scalar>
struct Stumpff {
  Scalar c2, c3;
};

/// The first `terms` of a power series in q, by Horner's rule.
template <std::size_t terms, class Scalar>
Scalar series(const Scalar& q, const std::array<double, 9>& coefficients) {
  Scalar sum = constant<Scalar>(coefficients[terms - 1]);
  for (std::size_t k = terms - 1; k-- > 0;) sum = sum * q + constant<Scalar>(coefficients[k]);
  return sum;
}

/// Relative error about 1e-16 for |u| < 1 (series), below 1e-15 beyond (closed form).
template <class Scalar>
Stumpff<Scalar> stumpff(const Scalar& u) {
  using std::cos;
  using std::sin;
  const Scalar q = u * u;
  if (value(q) < 1.0) {
    // Maclaurin coefficients (-1)^k / (2k+2)! and (-1)^k / (2k+3)!; the first left out is 2e-19.
    constexpr std::array<double, 9> even = {1.0 / 2,
                                            -1.0 / 24,
                                            1.0 / 720,
                                            -1.0 / 40320,
                                            1.0 / 3628800,
                                            -1.0 / 479001600,
                                            1.0 / 87178291200,
                                            -1.0 / 20922789888000,
                                            1.0 / 6402373705728000};
    constexpr std::array<double, 9> odd = {1.0 / 6,
                                           -1.0 / 120,
                                           1.0 / 5040,
                                           -1.0 / 362880,
                                           1.0 / 39916800,
                                           -1.0 / 6227020800,
                                           1.0 / 1307674368000,
                                           -1.0 / 355687428096000,
                                           1.0 / 121645100408832000};
    // NOTE: most flights turn by little; what is left out stays below 1e-16.
    if (value(q) < 1e-8) return {series<2>(q, even), series<2>(q, odd)};
    if (value(q) < 1e-4) return {series<3>(q, even), series<3>(q, odd)};
    if (value(q) < 1.0 / 64) return {series<5>(q, even), series<5>(q, odd)};
    return {series<9>(q, even), series<9>(q, odd)};
  }
  const Scalar one = constant<Scalar>(1.0);
  return {(one - cos(u)) / q, (u - sin(u)) / (q * u)};
}

/// An acceleration amplitude cos(angle + frequency t), held as amplitude cos(angle) and amplitude
/// sin(angle): no angle grows without bound, and turning it costs no trigonometry.
template <class Scalar>
struct Harmonic {
  Scalar cosine, sine;  ///< [m/s^2] at the start of the flight
  Scalar frequency;     ///< [rad/s], >= 0
};

template <class Scalar>
struct Motion {
  Scalar position;      ///< [m]
  Scalar velocity;      ///< [m/s]
  Scalar acceleration;  ///< [m/s^2]
};

/// The forces of a path alone.
struct AppliedForce {
  double acceleration;  ///< [m/s^2]
  double jerk;          ///< [m/s^3]
};

/// Bounds on what the forces of a path can do.
struct ForceBounds {
  double acceleration = 0;   ///< [m/s^2], the sum of the magnitudes
  double jerk = 0;           ///< [m/s^3]
  double snap = 0;           ///< [m/s^4]
  double shortest_step = 0;  ///< [s], below which the forces do not change within rounding
};

/// Free motion in closed form under x'' = steady + sum of harmonics, from a given start.
/// The constant part holds friction, so a flight is valid only while the velocity keeps its sign.
template <class Scalar>
struct Flight {
  Scalar position;                           ///< [m] at its start
  Scalar velocity;                           ///< [m/s] at its start
  Scalar steady;                             ///< [m/s^2]
  std::array<Harmonic<Scalar>, 2> harmonic;  ///< driver plate, disturbance
  int harmonics = 2;                         ///< how many of them act

  /// Exact up to rounding at any t [s] from the flight's start. Where the harmonics are then goes
  /// to `turned`, if asked for.
  Motion<Scalar> at(const Scalar& t, std::array<Harmonic<Scalar>, 2>* turned = nullptr) const {
    Motion<Scalar> m{position + t * (velocity + steady * t * constant<Scalar>(0.5)),
                     velocity + steady * t, steady};
    for (int i = 0; i < harmonics; ++i) {
      const auto& h = acting(i);
      const Scalar u = h.frequency * t;
      const auto [c2, c3] = stumpff(u);
      const Scalar one = constant<Scalar>(1.0);
      const Scalar q = u * u;
      const Scalar cosine = one - q * c2;
      const Scalar sinc = one - q * c3;  // sin(u) / u
      const Scalar sine = u * sinc;
      m.position += t * t * (h.cosine * c2 - h.sine * (u * c3));
      m.velocity += t * (h.cosine * sinc - h.sine * (u * c2));
      const Scalar now = h.cosine * cosine - h.sine * sine;
      m.acceleration += now;
      if (turned != nullptr) {
        (*turned)[static_cast<std::size_t>(i)] = {now, h.sine * cosine + h.cosine * sine,
                                                  h.frequency};
      }
    }
    return m;
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) { position += by; }

  /// The forces at any t >= 0 [s], more exactly than at() where t is long.
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

  /// Lets `t` [s] pass: the same flight, begun later.
  void advance(const Scalar& t) {
    const Motion<Scalar> m = at(t, &harmonic);
    position = m.position;
    velocity = m.velocity;
  }

  /// The second derivative of the position [m/s^2] at the start of the flight.
  Scalar acceleration() const {
    Scalar sum = steady;
    for (int i = 0; i < harmonics; ++i) sum += acting(i).cosine;
    return sum;
  }

  /// The third [m/s^3].
  Scalar jerk() const {
    Scalar sum = constant<Scalar>(0.0);
    for (int i = 0; i < harmonics; ++i) sum -= acting(i).frequency * acting(i).sine;
    return sum;
  }

  /// The fourth [m/s^4].
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

  /// Bounds up to a time [s] from the start. Two harmonics of nearly the same frequency that all
  /// but cancel have bounds far below the sum of their own, or the search would creep.
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

  /// The first Taylor coefficients of the acceleration at the start, which give it without loss up
  /// to `reach` [s].
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

  /// A lower bound on the speed in `direction` over the next `time` [s], and what the speed swings
  /// about but for the steady part [m/s].
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
      const bool slow = !(drop < amplitude * time);  // not a number where frequency is 0
      speeds.least -= slow ? amplitude * time : drop;
      if (!slow) speeds.mean -= sine / frequency;
    }
    return speeds;
  }

  /// The plain values, for searching events.
  Flight<double> plain() const {
    // Taken apart, plain numbers would cost a simulation some 6 % more.
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

  /// A bound up to a time on a derivative of both harmonics, 1 or 2, as one that changes slowly.
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

}  // namespace ricochet::carrier_track
