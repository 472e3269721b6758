#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <type_traits>

#include "problems/carrier_track/motion/harmonic.h"

namespace ricochet::carrier_track::inline flight {

/// Numbers of several bodies side by side, processed by one instruction: a Row is a
/// std::experimental::simd of double. The code for rows repeats the code for single numbers
/// operation by operation, so that the bits are the same.
namespace stdx = std::experimental;

template <class Row>
using MaskOf = typename Row::mask_type;

template <class Row>
[[gnu::always_inline]] inline Row select(const MaskOf<Row>& which,
                                         const std::type_identity_t<Row>& yes, Row no) {
  stdx::where(which, no) = yes;
  return no;
}

/// std::min and std::max, with the same result for NaN.
template <class Row>
[[gnu::always_inline]] inline Row least(const Row& a, const Row& b) {
  return select(b < a, b, a);
}
template <class Row>
[[gnu::always_inline]] inline Row most(const Row& a, const Row& b) {
  return select(a < b, b, a);
}

/// The Stumpff functions, see harmonic.h.
template <class Row>
struct StumpffRows {
  Row c2, c3;
};

/// The power series of stumpff() that begins with 1 / first!. Each body's series has as many terms
/// as stumpff() uses for its q.
template <int first, class Row>
[[gnu::always_inline]] inline Row stumpff_series(const Row& q) {
  constexpr auto coefficient = [](std::size_t k) {
    return (k % 2 == 0 ? 1 : -1) * inverse_factorials[first + 2 * k];
  };
  const MaskOf<Row> shortest = q < 1e-8;
  if (stdx::all_of(shortest)) return coefficient(1) * q + coefficient(0);
  Row sum = coefficient(4);
  const MaskOf<Row> short_enough = q < 1.0 / 64;
  if (!stdx::all_of(short_enough)) {
    Row longer = coefficient(8);
    for (std::size_t k = 8; k-- > 4;) longer = longer * q + coefficient(k);
    sum = select(short_enough, sum, longer);
  }
  sum = sum * q + coefficient(3);
  sum = select(q < 1e-4, coefficient(2), Row(sum * q + coefficient(2)));
  sum = select(shortest, coefficient(1), Row(sum * q + coefficient(1)));
  return sum * q + coefficient(0);
}

template <class Row>
[[gnu::always_inline]] inline StumpffRows<Row> stumpff_rows(const Row& u) {
  const Row q = u * u;
  StumpffRows<Row> result{stumpff_series<2>(q), stumpff_series<3>(q)};
  if (stdx::all_of(q < 1.0)) return result;
  for (std::size_t i = 0; i < Row::size(); ++i) {
    if (q[i] < 1.0) continue;
    // NOTE: not stumpff(): it would be compiled for two instruction sets under one name.
    const double angle = u[i];
    const double square = q[i];
    result.c2[i] = (1.0 - std::cos(angle)) / square;
    result.c3[i] = (angle - std::sin(angle)) / (square * angle);
  }
  return result;
}

/// Flights of several bodies, each under `harmonics` harmonics; see Flight.
template <class Row, int harmonics>
struct FlightRows {
  Row position, velocity, steady;
  std::array<Row, harmonics> cosine, sine, frequency;

  [[gnu::always_inline]] void advance(const Row& t) {
    position += t * (velocity + steady * t * 0.5);
    velocity += steady * t;
    swing<0>(t);  // GCC 12 does not unroll a loop over the harmonics, and keeps them in memory
    if constexpr (harmonics == 2) swing<1>(t);
  }

  /// Adds the motion under a harmonic.
  template <std::size_t h>
  [[gnu::always_inline]] void swing(const Row& t) {
    const Row u = frequency[h] * t;
    const auto [c2, c3] = stumpff_rows(u);
    const Row q = u * u;
    const Row c = 1.0 - q * c2;
    const Row sinc = 1.0 - q * c3;
    const Row s = u * sinc;
    position += t * t * (cosine[h] * c2 - sine[h] * (u * c3));
    velocity += t * (cosine[h] * sinc - sine[h] * (u * c2));
    const Row turned = cosine[h] * c - sine[h] * s;
    sine[h] = sine[h] * c + cosine[h] * s;
    cosine[h] = turned;
  }

  /// The acceleration with `sum` as its steady part.
  Row acceleration(Row sum) const {
    for (const Row& c : cosine) sum += c;
    return sum;
  }

  Row jerk() const {
    Row sum = 0.0;
    for (std::size_t h = 0; h < harmonics; ++h) sum -= frequency[h] * sine[h];
    return sum;
  }

  Row snap() const {
    Row sum = 0.0;
    for (std::size_t h = 0; h < harmonics; ++h) sum -= frequency[h] * frequency[h] * cosine[h];
    return sum;
  }

  Row jerk_bound() const {
    Row sum = 0.0;
    for (std::size_t h = 0; h < harmonics; ++h) {
      sum += frequency[h] * (stdx::abs(cosine[h]) + stdx::abs(sine[h]));
    }
    return sum;
  }

  Row amplitude(std::size_t h) const {
    return stdx::sqrt(cosine[h] * cosine[h] + sine[h] * sine[h]);
  }

  /// Copies the state of `other` for the bodies in `which`.
  void restore(const MaskOf<Row>& which, const FlightRows& other) {
    position = select(which, other.position, position);
    velocity = select(which, other.velocity, velocity);
    for (std::size_t h = 0; h < harmonics; ++h) {
      cosine[h] = select(which, other.cosine[h], cosine[h]);
      sine[h] = select(which, other.sine[h], sine[h]);
    }
  }

  /// See Flight::size, with another steady part.
  Row size(const Row& with) const {
    Row sum = stdx::abs(with);
    for (const Row& c : cosine) sum += stdx::abs(c);
    return sum;
  }
};

/// See ForceBounds, and Flight::bounds.
template <class Row, int harmonics>
struct BoundRows {
  Row acceleration, jerk, snap, shortest_step;

  BoundRows(const FlightRows<Row, harmonics>& flights, const Row& until)
      : acceleration(stdx::abs(flights.steady)), jerk(0.0), snap(0.0), shortest_step(0.0) {
    Row fastest = 0.0;
    for (std::size_t h = 0; h < harmonics; ++h) {
      const Row amplitude = flights.amplitude(h);
      const Row& frequency = flights.frequency[h];
      acceleration += amplitude;
      jerk += amplitude * frequency;
      snap += amplitude * frequency * frequency;
      fastest = select(amplitude > 0.0 && frequency > fastest, frequency, fastest);
    }
    shortest_step = select(fastest > 0.0, 1e-8 / fastest, Row(0.0));
    if constexpr (harmonics == 2) {
      jerk = least(jerk, together(flights, flights.frequency[0], flights.frequency[1], until));
      snap = least(snap, together(flights, flights.frequency[0] * flights.frequency[0],
                                  flights.frequency[1] * flights.frequency[1], until));
    }
  }

 private:
  static Row together(const FlightRows<Row, harmonics>& flights, const Row& first,
                      const Row& second, const Row& until) {
    const Row cosine = first * flights.cosine[0] + second * flights.cosine[1];
    const Row sine = first * flights.sine[0] + second * flights.sine[1];
    const Row apart = stdx::abs(flights.frequency[1] - flights.frequency[0]);
    const Row drift = second * flights.amplitude(1) * least(Row(2.0), apart * until);
    return stdx::sqrt(cosine * cosine + sine * sine) + select(apart > 0.0, drift, Row(0.0));
  }
};

}  // namespace ricochet::carrier_track::inline flight
