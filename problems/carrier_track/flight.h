#pragma once

#include <array>
#include <cmath>

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

/// Free motion in closed form under x'' = steady + sum of harmonics, from a given start.
/// The constant part holds friction, so a flight is valid only while the velocity keeps its sign.
template <class Scalar>
struct Flight {
  Scalar position;                           ///< [m] at its start
  Scalar velocity;                           ///< [m/s] at its start
  Scalar steady;                             ///< [m/s^2]
  std::array<Harmonic<Scalar>, 2> harmonic;  ///< driver plate, disturbance
  int harmonics = 2;                         ///< how many of them act

  /// Exact up to rounding at any t >= 0 [s] from the flight's start. Where the harmonics are when
  /// the flight ends goes to `turned`, if asked for.
  Motion<Scalar> at(const Scalar& t, std::array<Harmonic<Scalar>, 2>* turned = nullptr) const {
    Motion<Scalar> m{position + t * (velocity + steady * t * constant<Scalar>(0.5)),
                     velocity + steady * t, steady};
    for (int i = 0; i < harmonics; ++i) {
      const auto& h = harmonic[static_cast<std::size_t>(i)];
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

  /// x''' [m/s^3] at the start of the flight.
  Scalar jerk() const {
    Scalar sum = constant<Scalar>(0.0);
    for (int i = 0; i < harmonics; ++i) {
      const auto& h = harmonic[static_cast<std::size_t>(i)];
      sum -= h.frequency * h.sine;
    }
    return sum;
  }

  /// The plain values, for searching events.
  Flight<double> plain() const {
    Flight<double> result{value(position), value(velocity), value(steady), {}, harmonics};
    for (std::size_t i = 0; i < harmonic.size(); ++i) {
      result.harmonic[i] = {value(harmonic[i].cosine), value(harmonic[i].sine),
                            value(harmonic[i].frequency)};
    }
    return result;
  }
};

}  // namespace ricochet::carrier_track
