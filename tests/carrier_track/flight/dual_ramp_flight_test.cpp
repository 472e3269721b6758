#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/ramp_flight.h"
#include "tests/carrier_track/flight/random_ramp_forces.h"

namespace ricochet::carrier_track {
namespace {

using FourDual = ceres::Jet<double, 4>;
using SecondDual = ceres::Jet<ceres::Jet<double, 3>, 3>;

/// A number with derivatives of every order, or with none.
template <class T>
T random_dual(double x, RandomScenes& draws, bool varies = true) {
  if constexpr (Dual<T>) {
    T result(random_dual<Inner<T>>(x, draws, varies));
    for (int i = 0; varies && i < T::DIMENSION; ++i) {
      result.v[i] = random_dual<Inner<T>>(draws.within(-1, 1), draws);
    }
    return result;
  } else {
    return x;
  }
}

template <class T>
RampForces<T> random_duals(RandomScenes& draws, bool plate_varies, bool disturbed) {
  const RampForces<double> f = random_ramp_forces(draws);
  const auto plate = [&](double x) { return random_dual<T>(x, draws, plate_varies); };
  const auto vary = [&](double x) { return random_dual<T>(x, draws); };
  RampForces<T> result{
      {plate(f.plate.steady), plate(f.plate.square), plate(f.plate.cosine),
       plate(f.plate.square_cosine), plate(f.plate.slope_cosine), plate(f.plate.sine),
       plate(f.plate.square_sine), plate(f.plate.slope_sine)},
      {vary(f.disturbance.cosine), vary(f.disturbance.sine), vary(f.disturbance.frequency)},
      vary(f.alpha),
      vary(f.omega),
      vary(f.slope)};
  if (!disturbed) result.disturbance.cosine = result.disturbance.sine = constant<T>(0.0);
  return result;
}

/// All that a dual is made of.
template <class T>
void expect_near(const T& a, const T& b, double tolerance) {
  if constexpr (Dual<T>) {
    expect_near(a.a, b.a, tolerance);
    for (int i = 0; i < T::DIMENSION; ++i) expect_near(a.v[i], b.v[i], tolerance);
  } else {
    EXPECT_NEAR(a, b, tolerance);
  }
}

template <class T>
class TangentFlightOf : public testing::Test {};
using Duals = testing::Types<FourDual, SecondDual>;
TYPED_TEST_SUITE(TangentFlightOf, Duals);

TYPED_TEST(TangentFlightOf, IsThatOfAPowerSeriesOfDuals) {
  RandomScenes draws(1);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const auto forces = random_duals<TypeParam>(draws, i % 3 > 0, i % 2 > 0);
    const auto position = random_dual<TypeParam>(0.3, draws);
    const auto velocity = random_dual<TypeParam>(-0.2, draws);
    const auto push = random_dual<TypeParam>(0.4, draws);
    DualRampFlight<TypeParam> flight(random_dual<TypeParam>(9, draws), velocity, forces);
    RampFlight<TypeParam> series(position, velocity, forces);
    flight.start(position, velocity);
    flight.push(push);
    series.push(push);
    EXPECT_EQ(flight.reach(), series.reach());
    const auto expect_same = [&](const Motion<TypeParam>& a, const Motion<TypeParam>& b) {
      expect_near(a.position, b.position, 1e-12);
      expect_near(a.velocity, b.velocity, 1e-11);
      expect_near(a.acceleration, b.acceleration, 1e-10 * (1 + flight.size()));
    };
    expect_near(flight.acceleration(), series.acceleration(), 1e-12 * (1 + flight.size()));
    const auto t = random_dual<TypeParam>(flight.reach() * draws.within(0, 0.5), draws);
    expect_same(flight.at(t), series.at(t));
    const auto by = random_dual<TypeParam>(2.0, draws);
    flight.shift(by);
    series.shift(by);
    flight.advance(t);
    series.advance(t);
    expect_near(flight.position, series.position, 1e-12);
    expect_same(flight.at(t), series.at(t));
    EXPECT_NEAR(flight.plain().velocity, value(series.velocity), 1e-14);
    if (this->HasFailure()) return;
  }
}

TYPED_TEST(TangentFlightOf, SlidesAlongItsMotion) {
  RandomScenes draws(2);
  for (int i = 0; i < 50; ++i) {
    DualRampFlight<TypeParam> flight(random_dual<TypeParam>(0.3, draws),
                                     random_dual<TypeParam>(-0.2, draws),
                                     random_duals<TypeParam>(draws, true, true));
    const DualRampFlight<TypeParam> start = flight;
    TypeParam t = random_dual<TypeParam>(0.0, draws);
    t.a = constant<Inner<TypeParam>>(0.0);
    flight.shift_time_derivative(t.v);
    expect_near(flight.position, start.at(t).position, 1e-13);
    expect_near(flight.velocity, start.at(t).velocity, 1e-12);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
