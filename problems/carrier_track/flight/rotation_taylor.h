#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "problems/carrier_track/flight/flight.h"

namespace ricochet::carrier_track::inline flight {

/// The number of coefficients of a power series in time. With 16 terms the truncation error is
/// below rounding up to a third of a radian.
inline constexpr std::size_t series_terms = 16;
template <class Scalar>
using Series = std::array<Scalar, series_terms>;

/// An acceleration as a series, and its integrals over time t [s]: the position is t^2 times, and
/// the velocity t times, the returned value, so that the start can be added without loss of
/// accuracy.
template <class Scalar, class Time>
Motion<Scalar> integrals(const Series<Scalar>& series, const Time& t) {
  Scalar a = constant<Scalar>(0.0);
  Scalar v = a;
  Scalar x = a;
  for (std::size_t k = series_terms; k-- > 0;) {
    const auto order = static_cast<double>(k);
    a = a * t + series[k];
    v = v * t + scaled(series[k], 1 / (order + 1));
    x = x * t + scaled(series[k], 1 / ((order + 1) * (order + 2)));
  }
  return {x, v, a};
}

/// omega^2, cos alpha and sin alpha, and their products, as series in time while omega, the rate of
/// alpha, changes linearly.
template <class Scalar>
struct RotationTaylor {
  std::array<Scalar, 3> square;  ///< all its coefficients
  Series<Scalar> cosine, sine;
  Series<Scalar> square_cosine, square_sine;

  RotationTaylor(const Scalar& alpha, const Scalar& omega, const Scalar& slope)
      : square{omega * omega, scaled(omega * slope, 2), slope * slope} {
    using std::cos;
    using std::sin;
    const Scalar zero = constant<Scalar>(0.0);
    // From (cos alpha)' = -omega sin alpha.
    cosine[0] = cos(alpha);
    sine[0] = sin(alpha);
    for (std::size_t k = 0; k + 1 < series_terms; ++k) {
      const double share = 1.0 / static_cast<double>(k + 1);
      cosine[k + 1] = scaled(omega * sine[k] + (k > 0 ? slope * sine[k - 1] : zero), -share);
      sine[k + 1] = scaled(omega * cosine[k] + (k > 0 ? slope * cosine[k - 1] : zero), share);
    }
    for (std::size_t k = 0; k < series_terms; ++k) {
      square_cosine[k] = square_sine[k] = zero;
      for (std::size_t i = 0; i < 3 && i <= k; ++i) {
        square_cosine[k] += square[i] * cosine[k - i];
        square_sine[k] += square[i] * sine[k - i];
      }
    }
  }
};

}  // namespace ricochet::carrier_track::inline flight
