#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline flight {

/// c2 = (1 - cos u) / u^2 and c3 = (u - sin u) / u^3, the Stumpff functions of u^2. They give all
/// that a flight under harmonic forces needs without cancellation, also at u = 0.
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
    // Maclaurin coefficients (-1)^k / (2k+2)! and (-1)^k / (2k+3)!; the first omitted one is 2e-19.
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
    // NOTE: most flights have small u; the omitted terms stay below 1e-16.
    if (value(q) < 1e-8) return {series<2>(q, even), series<2>(q, odd)};
    if (value(q) < 1e-4) return {series<3>(q, even), series<3>(q, odd)};
    if (value(q) < 1.0 / 64) return {series<5>(q, even), series<5>(q, odd)};
    return {series<9>(q, even), series<9>(q, odd)};
  }
  const Scalar one = constant<Scalar>(1.0);
  return {(one - cos(u)) / q, (u - sin(u)) / (q * u)};
}

/// 1 / k!
inline constexpr std::array<double, 32> inverse_factorials = [] {
  std::array<double, 32> result{};
  double product = 1;
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (k > 1) product *= static_cast<double>(k);
    result[k] = 1 / product;
  }
  return result;
}();

/// The Stumpff functions c2, c3, ... c(2 pairs + 1) of u^2: ck is the sum of (-u^2)^i / (k + 2i)!.
/// The derivative of each follows from two of higher order, dck/du = u (k c(k+2) - c(k+1)), so the
/// functions of a dual follow from those of its real part.
template <std::size_t pairs, class Scalar>
std::array<Scalar, 2 * pairs> stumpff_functions(const Scalar& u) {
  std::array<Scalar, 2 * pairs> result;
  if constexpr (Dual<Scalar>) {
    const auto inner = stumpff_functions<pairs + 1>(u.a);
    for (std::size_t i = 0; i < 2 * pairs; ++i) {
      result[i].a = inner[i];
      const Inner<Scalar> rise = scaled(inner[i + 2], static_cast<double>(i + 2)) - inner[i + 1];
      result[i].v = u.v * (u.a * rise);
    }
  } else if constexpr (pairs == 1) {
    const auto [c2, c3] = stumpff(u);
    result = {c2, c3};
  } else {
    const Scalar q = u * u;
    if (value(q) < 1.0) {  // downward from the last two, without cancellation
      constexpr std::size_t last = 2 * pairs;
      Scalar even = constant<Scalar>(0.0);
      Scalar odd = even;
      for (std::size_t k = value(q) < 1.0 / 64 ? 10 : 18; k > 0; k -= 2) {
        even = constant<Scalar>(inverse_factorials[last + k - 2]) - q * even;
        odd = constant<Scalar>(inverse_factorials[last + k - 1]) - q * odd;
      }
      result[last - 2] = even;
      result[last - 1] = odd;
      for (std::size_t i = last - 2; i-- > 0;) {
        result[i] = constant<Scalar>(inverse_factorials[i + 2]) - q * result[i + 2];
      }
    } else {
      const auto [c2, c3] = stumpff(u);
      result[0] = c2;
      result[1] = c3;
      for (std::size_t i = 2; i < 2 * pairs; ++i) {
        result[i] = (constant<Scalar>(inverse_factorials[i]) - result[i - 2]) / q;
      }
    }
  }
  return result;
}

/// An acceleration amplitude cos(angle + frequency t), stored as amplitude cos(angle) and amplitude
/// sin(angle). No angle grows without bound.
template <class Scalar>
struct Harmonic {
  Scalar cosine, sine;  ///< [m/s^2] at the start of the flight
  Scalar frequency;     ///< [rad/s], >= 0
};

/// The motion of a body, at rest at zero before, under a harmonic acceleration alone, and the
/// harmonic at that time.
template <class Scalar>
struct Swung {
  Scalar position, velocity;  ///< [m], [m/s]
  Scalar cosine, sine;        ///< of the harmonic at that time
};

/// The motion and the harmonic after a time [s]. The derivatives of a dual follow from partial
/// derivatives in its inner arithmetic.
template <class Scalar>
Swung<Scalar> swung(const Harmonic<Scalar>& h, const Scalar& t) {
  const Scalar one = constant<Scalar>(1.0);
  Swung<Scalar> result;
  if constexpr (Dual<Scalar>) {
    const auto& time = t.a;
    const auto& frequency = h.frequency.a;
    const auto u = frequency * time;
    const auto [c2, c3, c4, c5] = stumpff_functions<2>(u);
    const auto square = time * time;
    const auto cosine = one.a - u * u * c2;
    const auto sinc = one.a - u * u * c3;
    const auto sine = u * sinc;
    const auto fall = square * c2;
    const auto lag = square * (u * c3);
    const auto gain = time * sinc;
    const auto loss = time * (u * c2);
    result.position.a = h.cosine.a * fall - h.sine.a * lag;
    result.velocity.a = h.cosine.a * gain - h.sine.a * loss;
    result.cosine.a = h.cosine.a * cosine - h.sine.a * sine;
    result.sine.a = h.sine.a * cosine + h.cosine.a * sine;
    result.position.v = h.cosine.v * fall - h.sine.v * lag;
    result.velocity.v = h.cosine.v * gain - h.sine.v * loss;
    result.cosine.v = h.cosine.v * cosine - h.sine.v * sine;
    result.sine.v = h.sine.v * cosine + h.cosine.v * sine;
    if (!is_constant(h.frequency)) {
      const auto two_c4 = c4 + c4;
      const auto late = u * (two_c4 - c3);
      const auto early = c3 + u * u * (c5 + c5 + c5 - c4);
      const auto& v = h.frequency.v;
      result.position.v += v * (time * square * (h.cosine.a * late - h.sine.a * early));
      result.velocity.v += v * (square * (h.sine.a * (c2 - sinc) - h.cosine.a * (u * (c2 - c3))));
      result.cosine.v -= v * (time * result.sine.a);
      result.sine.v += v * (time * result.cosine.a);
    }
    if (!is_constant(t)) {
      result.position.v += t.v * result.velocity.a;
      result.velocity.v += t.v * result.cosine.a;
      result.cosine.v -= t.v * (frequency * result.sine.a);
      result.sine.v += t.v * (frequency * result.cosine.a);
    }
  } else {
    const Scalar u = h.frequency * t;
    const auto [c2, c3] = stumpff(u);
    const Scalar q = u * u;
    const Scalar cosine = one - q * c2;
    const Scalar sinc = one - q * c3;  // sin(u) / u
    const Scalar sine = u * sinc;
    result.position = t * t * (h.cosine * c2 - h.sine * (u * c3));
    result.velocity = t * (h.cosine * sinc - h.sine * (u * c2));
    result.cosine = h.cosine * cosine - h.sine * sine;
    result.sine = h.sine * cosine + h.cosine * sine;
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline flight
