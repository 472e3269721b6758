#include "problems/carrier_track/motion/ramp_flight.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"
#include "tests/carrier_track/flight/random_ramp_forces.h"

namespace ricochet::carrier_track {
namespace {

/// The acceleration as the definition of PlateForces has it.
double acceleration(const RampForces<double>& f, double t) {
  const double omega = f.omega + f.slope * t;
  const double alpha = f.alpha + t * (f.omega + f.slope * t / 2);
  const double angle = f.disturbance.frequency * t;
  return f.plate.steady + f.plate.square * omega * omega +
         (f.plate.cosine + f.plate.square_cosine * omega * omega + f.plate.slope_cosine * f.slope) *
             std::cos(alpha) +
         (f.plate.sine + f.plate.square_sine * omega * omega + f.plate.slope_sine * f.slope) *
             std::sin(alpha) +
         f.disturbance.cosine * std::cos(angle) - f.disturbance.sine * std::sin(angle);
}

TEST(RampFlight, IsTheDoubleIntegralOfTheForcesOverItsReach) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  RandomScenes draws(1);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const RampForces<double> forces = random_ramp_forces(draws);
    const RampFlight<double> flight(0.3, -0.2, forces);
    const double t = flight.reach() * draws.within(0, 1);
    const Motion<double> m = flight.at(t);
    const double size = flight.size();
    EXPECT_NEAR(m.acceleration, acceleration(forces, t), 1e-14 * size);
    const double gain = Gauss::integrate([&](double s) { return acceleration(forces, s); }, 0.0, t);
    EXPECT_NEAR(m.velocity, -0.2 + gain, 1e-15 + 1e-14 * size * t);
    const double way =
        Gauss::integrate([&](double s) { return (t - s) * acceleration(forces, s); }, 0.0, t);
    EXPECT_NEAR(m.position, 0.3 - 0.2 * t + way, 2e-16 + 1e-14 * size * t * t);
  }
}

TEST(RampFlight, KnowsItsDerivativesAndBounds) {
  RandomScenes draws(2);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    RampFlight<double> flight(0.0, 0.0, random_ramp_forces(draws));
    const RampFlight<double> start = flight;
    const double reach = flight.reach();
    flight.advance(reach * draws.within(0.1, 0.9));
    const double h = 1e-4 * reach;
    const auto push = [&](double t) { return flight.at(t).acceleration; };
    EXPECT_EQ(flight.acceleration(), push(0));
    EXPECT_NEAR(flight.jerk(), (push(h) - push(-h)) / (2 * h), 1e-6 * flight.jerk_bound());
    EXPECT_NEAR(flight.snap(), (push(h) - 2 * push(0) + push(-h)) / (h * h),
                1e-4 * flight.bounds(reach).snap);
    EXPECT_LE(std::abs(flight.acceleration()), start.bounds(reach).acceleration * (1 + 1e-12));
    EXPECT_LE(std::abs(flight.jerk()), start.jerk_bound() * (1 + 1e-12));
    EXPECT_LE(std::abs(flight.snap()), start.bounds(reach).snap * (1 + 1e-12));
  }
}

TEST(RampFlight, GoesOnAfterAnAdvanceAsBefore) {
  RandomScenes draws(3);
  for (int i = 0; i < 100; ++i) {
    const RampFlight<double> flight(0.3, -0.2, random_ramp_forces(draws));
    const double t = 0.4 * flight.reach();
    RampFlight<double> later = flight;
    later.advance(t);
    later.shift(1.0);
    EXPECT_EQ(later.position, flight.at(t).position + 1.0);
    EXPECT_NEAR(later.at(t).position, flight.at(2 * t).position + 1.0, 4e-16);
    EXPECT_NEAR(later.at(t).velocity, flight.at(2 * t).velocity, 1e-15);
  }
}

TEST(RampFlight, CarriesDerivativesWithRespectToTheSlope) {
  using Jet = ceres::Jet<double, 1>;
  RandomScenes draws(4);
  for (int i = 0; i < 100; ++i) {
    const RampForces<double> f = random_ramp_forces(draws);
    const auto position_at = [&](const auto& slope, double t) {
      using Scalar = std::decay_t<decltype(slope)>;
      const auto lift = [](double x) { return constant<Scalar>(x); };
      const RampForces<Scalar> forces{
          {lift(f.plate.steady), lift(f.plate.square), lift(f.plate.cosine),
           lift(f.plate.square_cosine), lift(f.plate.slope_cosine), lift(f.plate.sine),
           lift(f.plate.square_sine), lift(f.plate.slope_sine)},
          {lift(f.disturbance.cosine), lift(f.disturbance.sine), lift(f.disturbance.frequency)},
          lift(f.alpha),
          lift(f.omega),
          slope};
      return RampFlight<Scalar>(lift(0), lift(0), forces).at(lift(t)).position;
    };
    const double t = 0.2 / (f.omega + std::sqrt(std::abs(f.slope)) + f.disturbance.frequency);
    const double h = 1e-4;
    const double difference = (position_at(f.slope + h, t) - position_at(f.slope - h, t)) / (2 * h);
    EXPECT_NEAR(position_at(Jet(f.slope, 0), t).v[0], difference, 1e-9 * t * t);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
