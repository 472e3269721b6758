#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "problems/carrier_track/motion/flight.h"

namespace ricochet::carrier_track {

/// A flight seen in its direction, in long double and by the plain integrals of its forces.
struct TrueValues {
  const Flight<double>& flight;
  int direction;

  long double push(long double t) const {
    long double a = flight.steady;
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      a += h.cosine * std::cos(h.frequency * t) - h.sine * std::sin(h.frequency * t);
    }
    return direction * a;
  }
  long double speed(long double t) const {
    long double v = flight.velocity + flight.steady * t;
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      const long double half = std::sin(h.frequency * t / 2);
      v += (h.cosine * std::sin(h.frequency * t) - h.sine * 2 * half * half) / h.frequency;
    }
    return direction * v;
  }
  long double distance(long double t) const {
    long double x = t * (flight.velocity + flight.steady * t / 2);
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      const long double u = h.frequency * t;
      const long double half = std::sin(u / 2);
      const long double square = static_cast<long double>(h.frequency) * h.frequency;
      x += (h.cosine * 2 * half * half - h.sine * (u - std::sin(u))) / square;
    }
    return direction * x;
  }
};

class RandomFlightTest : public testing::Test {
 protected:
  double within(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  double log_within(double a, double b) { return a * std::pow(b / a, within(0, 1)); }

  Harmonic<double> random_harmonic() { return {within(-1, 1), within(-1, 1), log_within(0.3, 30)}; }

  Flight<double> random_flight() {
    return {within(-1, 1), 0.0, within(-1, 1), {{random_harmonic(), random_harmonic()}}, 2};
  }

  std::mt19937_64 random_{1};
  std::int64_t evaluations_ = 0;
};

}  // namespace ricochet::carrier_track
