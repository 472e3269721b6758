#include "problems/carrier_track/motion/flight.h"

#include <ceres/jet.h>

#include <boost/math/quadrature/gauss.hpp>

#include "tests/carrier_track/models/watch.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Integral over [0, upper] of a function that turns by at most `angle` [rad] there, in long
/// double: no differences of large numbers, whatever the angle.
template <class Function>
long double integral(Function f, long double upper, long double angle) {
  const auto panels = static_cast<int>(std::ceil(angle / 2)) + 1;
  long double sum = 0;
  for (int i = 0; i < panels; ++i) {
    sum += boost::math::quadrature::gauss<long double, 20>::integrate(f, upper * i / panels,
                                                                      upper * (i + 1) / panels);
  }
  return sum;
}

TEST(Flight, StumpffFunctionsAreRightAtEveryAngle) {
  // With those where the formula changes.
  std::vector<double> angles = {0.125, std::nextafter(0.125, 0.0), 1, std::nextafter(1.0, 0.0)};
  for (double u = 1e-12; u < 1e9; u *= 1.07) angles.push_back(u);
  for (const double u : angles) {
    const long double q = static_cast<long double>(u) * u;
    long double c2 = (1 - std::cos(static_cast<long double>(u))) / q;
    long double c3 = (1 - std::sin(static_cast<long double>(u)) / u) / q;
    if (u < 10) {  // where the closed form cancels
      c2 = integral([&](long double s) { return (1 - s) * std::cos(u * s); }, 1.0L, u);
      c3 =
          integral([&](long double s) { return (1 - s) * (1 - s) / 2 * std::cos(u * s); }, 1.0L, u);
    }
    // c2 has zeros at whole turns: its error is judged against its envelope 2 / u^2.
    const double envelope = std::min(0.5, 2 / (u * u));
    EXPECT_NEAR(stumpff(u).c2, static_cast<double>(c2), 4e-16 * envelope) << u;
    EXPECT_NEAR(stumpff(u).c3 / static_cast<double>(c3), 1.0, 1e-15) << u;
    EXPECT_EQ(stumpff(-u).c2, stumpff(u).c2) << u;
    EXPECT_EQ(stumpff(-u).c3, stumpff(u).c3) << u;
  }
  EXPECT_EQ(stumpff(0.0).c2, 0.5);
  EXPECT_EQ(stumpff(0.0).c3, 1.0 / 6);
}

TEST(Flight, StumpffFunctionsOfHigherOrderAndTheirDerivativesAreRight) {
  // c(k) is the integral of (1 - s)^(k - 1) / (k - 1)! cos(u s) over 0..1.
  using Jet = ceres::Jet<double, 1>;
  for (double u = 1e-6; u < 30; u *= 1.3) {
    const auto high = stumpff_functions<3>(u);
    const auto low = stumpff_functions<1>(Jet(u, 0));
    for (std::size_t k = 2; k < 8; ++k) {
      SCOPED_TRACE(testing::Message() << k << " at " << u);
      const auto factorial = std::tgamma(static_cast<long double>(k));
      const auto weight = [&](long double s) {
        return std::pow(1 - s, static_cast<long double>(k - 1)) / factorial;
      };
      const auto c = integral([&](long double s) { return weight(s) * std::cos(u * s); }, 1.0L, u);
      const auto size = static_cast<double>(k * factorial);
      EXPECT_NEAR(high[k - 2], static_cast<double>(c), 1e-13 / size);
      if (k > 3) continue;
      const auto rise =
          integral([&](long double s) { return -s * weight(s) * std::sin(u * s); }, 1.0L, u);
      EXPECT_NEAR(low[k - 2].a, static_cast<double>(c), 1e-15);
      EXPECT_NEAR(low[k - 2].v[0], static_cast<double>(rise), 1e-15);
    }
  }
}

Flight<double> random_flight(RandomScenes& draws, double slowest, double fastest) {
  const auto within = [&] { return draws.within(-1, 1); };
  const auto harmonic = [&] {
    return Harmonic<double>{within(), within(), draws.log_within(slowest, fastest)};
  };
  return {within(), within(), within(), {{harmonic(), harmonic()}}, 2};
}

/// The largest size the terms of a motion reach by `t`: what rounding is relative to.
Motion<double> scale_of(const Flight<double>& f, double t) {
  double acceleration = std::abs(f.steady);
  for (const auto& h : f.harmonic) acceleration += std::abs(h.cosine) + std::abs(h.sine);
  return {std::abs(f.position) + t * (std::abs(f.velocity) + t * acceleration),
          std::abs(f.velocity) + t * acceleration, acceleration};
}

TEST(Flight, FollowsItsForcesInClosedForm) {
  for_random(1, 2000, [](RandomScenes& draws) {
    const Flight<double> f = random_flight(draws, 1e-9, 300.0);
    const double t = draws.log_within(1e-6, 3);
    const auto acceleration = [&](long double s) {
      long double a = f.steady;
      for (const auto& h : f.harmonic) {
        a += h.cosine * std::cos(h.frequency * s) - h.sine * std::sin(h.frequency * s);
      }
      return a;
    };
    const long double angle = t * std::max(f.harmonic[0].frequency, f.harmonic[1].frequency);
    const long double velocity = f.velocity + integral(acceleration, t, angle);
    const long double position =
        f.position + t * static_cast<long double>(f.velocity) +
        integral([&](long double s) { return (t - s) * acceleration(s); }, t, angle);
    const Motion<double> m = f.at(t);
    const Motion<double> scale = scale_of(f, t);
    EXPECT_NEAR(m.position, static_cast<double>(position), 1e-15 * scale.position);
    EXPECT_NEAR(m.velocity, static_cast<double>(velocity), 1e-15 * scale.velocity);
    // The rounding of an angle of many radians is felt in its sine.
    EXPECT_NEAR(m.acceleration, static_cast<double>(acceleration(t)),
                (2e-15 + 3e-16 * static_cast<double>(angle)) * scale.acceleration);
  });
}

TEST(Flight, StaysExactAfterAMillionTurns) {
  const double t = 2.1e6;
  const Flight<double> f{0.5, -0.25, 0.0, {{{1.5, 0.5, 3.0}, {}}}, 1};
  // x = x0 + v0 t + (c (1 - cos u) - s (u - sin u)) / w^2
  const long double u = 3.0L * t;
  const long double position =
      0.5L - 0.25L * t + (1.5L * (1 - std::cos(u)) - 0.5L * (u - std::sin(u))) / 9;
  const long double velocity = -0.25L + (1.5L * std::sin(u) - 0.5L * (1 - std::cos(u))) / 3;
  EXPECT_NEAR(f.at(t).position / static_cast<double>(position), 1.0, 1e-15);
  EXPECT_NEAR(f.at(t).velocity, static_cast<double>(velocity), 1e-9);
}

TEST(Flight, IgnoresHarmonicsThatDoNotAct) {
  const Flight<double> f{0.0, 1.0, 2.0, {{{9.0, 9.0, 9.0}, {9.0, 9.0, 9.0}}}, 0};
  EXPECT_THAT(f.at(0.5), FieldsAre(0.75, 2.0, 2.0));
  EXPECT_EQ(f.jerk(), 0.0);
}

TEST(Flight, HasDualsWhoseTimeDerivativesAreItsOwnMotion) {
  using Jet = ceres::Jet<double, 1>;
  for_random(2, 1000, [](RandomScenes& draws) {
    const Flight<double> f = random_flight(draws, 1e-3, 100.0);
    const double t = draws.within(1e-3, 2.0);
    Flight<Jet> dual{Jet(f.position), Jet(f.velocity), Jet(f.steady), {}, 2};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& h = f.harmonic[i];
      dual.harmonic[i] = {Jet(h.cosine), Jet(h.sine), Jet(h.frequency)};
    }
    const Motion<double> plain = f.at(t);
    const Motion<Jet> m = dual.at(Jet(t, 0));
    const Motion<double> scale = scale_of(f, t);
    EXPECT_NEAR(m.position.a, plain.position, 1e-15 * scale.position);
    EXPECT_NEAR(m.velocity.a, plain.velocity, 1e-15 * scale.velocity);
    EXPECT_NEAR(m.position.v[0], plain.velocity, 1e-13 * scale.velocity);
    EXPECT_NEAR(m.velocity.v[0], plain.acceleration, 1e-13 * scale.acceleration);
    EXPECT_NEAR(dual.at(Jet(0.0, 0)).acceleration.v[0], f.jerk(), 1e-13 * (1 + std::abs(f.jerk())));
    EXPECT_EQ(dual.plain().at(t).position, plain.position);
  });
}

}  // namespace
}  // namespace ricochet::carrier_track
