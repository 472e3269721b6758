#include "problems/carrier_track/motion/ramp_flight.h"

#include <ceres/jet.h>

#include <boost/math/quadrature/gauss.hpp>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Forces that use every term of RampForces.
RampForces<double> random_ramp_forces(RandomScenes& draws) {
  const auto within = [&](double a, double b) { return draws.within(a, b); };
  return {{within(-1, 1), within(-0.1, 0.1), within(-1, 1), within(-0.1, 0.1), within(-0.1, 0.1),
           within(-1, 1), within(-0.1, 0.1), within(-0.1, 0.1)},
          {within(-1, 1), within(-1, 1), draws.log_within(0.3, 30)},
          within(-4, 4),
          draws.log_within(0.3, 20),
          draws.chance(0.2) ? 0.0 : within(-20, 20)};
}

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

TEST(RampFlight, IsTheDoubleIntegralOfTheForcesOverItsReachAlsoAfterAnAdvance) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  for_random(1, 300, [](RandomScenes& draws) {
    const RampForces<double> forces = random_ramp_forces(draws);
    const RampFlight<double> flight(0.3, -0.2, forces);
    const double t = flight.reach() * draws.within(0, 1);
    const auto push = [&](double s) { return acceleration(forces, s); };
    const double gain = Gauss::integrate(push, 0.0, t);
    const double way = Gauss::integrate([&](double s) { return (t - s) * push(s); }, 0.0, t);
    const double size = flight.size();
    RampFlight<double> later = flight;
    later.advance(t / 2);
    later.shift(1.0);
    EXPECT_EQ(later.position, flight.at(t / 2).position + 1.0);
    for (const auto& [motion, shift] : {std::pair(flight.at(t), 0.0), {later.at(t / 2), 1.0}}) {
      EXPECT_NEAR(motion.acceleration, push(t), 1e-14 * size);
      EXPECT_NEAR(motion.velocity, -0.2 + gain, 1e-15 + 1e-14 * size * t);
      EXPECT_NEAR(motion.position, 0.3 - 0.2 * t + way + shift, 4e-16 + 1e-14 * size * t * t);
    }
  });
}

TEST(RampFlight, KnowsItsDerivativesAndBounds) {
  for_random(2, 300, [](RandomScenes& draws) {
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
  });
}

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
  const T zero = constant<T>(0.0);
  return {{plate(f.plate.steady), plate(f.plate.square), plate(f.plate.cosine),
           plate(f.plate.square_cosine), plate(f.plate.slope_cosine), plate(f.plate.sine),
           plate(f.plate.square_sine), plate(f.plate.slope_sine)},
          {disturbed ? vary(f.disturbance.cosine) : zero,
           disturbed ? vary(f.disturbance.sine) : zero, vary(f.disturbance.frequency)},
          vary(f.alpha),
          vary(f.omega),
          vary(f.slope)};
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
using FlownDuals = testing::Types<ceres::Jet<double, 4>, ceres::Jet<ceres::Jet<double, 3>, 3>>;
TYPED_TEST_SUITE(TangentFlightOf, FlownDuals);

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

/// Expects the same motion under a profile of some knots, made for a speed, as under more of them,
/// in random scenes whose paths do not make much of a change in the last digit. Returns how many
/// those are.
template <class Profile, class MoreKnots>
int expect_same_motion(std::uint64_t seed, int trials, bool planar, const Profile& profile,
                       const MoreKnots& more_knots) {
  int compared = 0;
  for_random(seed, trials, [&](RandomScenes& draws) {
    Scene scene = planar ? draws.next_planar() : draws.next();
    const double omega = scene.omega;
    scene.profile = profile(omega);
    const Recording expected = record(scene, 0.25, 0);
    const Recording near = record(with(scene, set::mass(scene.mass * (1 + 1e-13))), 0.25, 0);
    if (near.impacts.size() != expected.impacts.size()) return;
    if (!(std::abs(near.end.position - expected.end.position) < 1e-11)) return;
    scene.profile = more_knots(omega, draws);
    const Recording actual = record(scene, 0.25, 0);
    expect_hits(actual.impacts, expected.impacts, 1e-9, 1e-9);
    ASSERT_NEAR(actual.end.position, expected.end.position, 1e-9);
    ASSERT_NEAR(actual.end.time, expected.end.time, 1e-14 * expected.end.time);
    ++compared;
  });
  return compared;
}

using Knots = std::vector<SpeedKnot<double>>;

TEST(ProfileForces, OfOneKnotAreThoseOfAConstantSpeed) {
  const auto no_knots = [](double) { return Knots(); };
  const auto one_knot = [](double omega, auto& draws) {
    return Knots{{draws.within(0, 1), omega}};
  };
  EXPECT_GT(expect_same_motion(1, 300, false, no_knots, one_knot), 200);
  EXPECT_GT(expect_same_motion(9, 200, true, no_knots, one_knot), 130);
}

TEST(ProfileForces, DoNotMindAKnotWithinALeg) {
  const auto leg = [](double omega) { return Knots{{0.0, omega}, {0.8, 2 * omega}}; };
  const auto parts = [](double omega, auto& /*draws*/) {
    return Knots{{0.0, omega}, {0.2, 1.25 * omega}, {0.3, 1.375 * omega}, {0.8, 2 * omega}};
  };
  EXPECT_GT(expect_same_motion(2, 200, false, leg, parts), 150);
}

TEST(ProfileForces, ASpinUpWithoutOtherForcesActsThroughTheSlidersAlone) {
  // x'' = -s (omega' sin alpha + omega^2 cos alpha) / m is the second derivative of s cos(alpha) /
  // m.
  const Scene scene = with(Scene{}, set::mass(1.3), set::walls(-100, 100), set::start(0.5, 0.02),
                           set::slider_mass_radius(0.4), set::phase(0.7),
                           set::profile(Knots{{0.1, 1.0}, {2.1, 9.0}}), set::seconds(2.1));
  const double alpha = 0.7 + 0.1 + 2.0 * 5.0;
  const double share = 0.4 / 1.3;
  const double expected = 0.5 + 0.02 * 2.1 + share * (std::cos(alpha) - std::cos(0.7)) +
                          share * std::sin(0.7) * 1.0 * 2.1;
  EXPECT_NEAR(record(scene, 0.25, 0).end.position, expected, 1e-13);
}

TEST(ProfileForces, AtAKnotAtTheStartAreThoseAfterIt) {
  // As above, from rest: the first ramp may push the body the other way than a constant speed.
  int reversed = 0;
  for_random(3, 300, [&](RandomScenes& draws) {
    const double phase = draws.within(-4, 4), end = draws.within(0.1, 2);
    const double first = draws.within(0.3, 5), last = draws.within(0.3, 5);
    const Scene scene =
        with(Scene{}, set::mass(1.3), set::walls(-100, 100), set::start(0.5, 0), set::friction(0),
             set::pull(0), set::slider_mass_radius(0.4), set::phase(phase), set::seconds(end),
             set::profile(Knots{{0.0, first}, {end, last}}));
    const double steady = first * first * std::cos(phase);
    const double ramp = (last - first) / end * std::sin(phase);
    reversed += steady * (steady + ramp) < 0;
    const double alpha = phase + (first + last) / 2 * end;
    const double share = 0.4 / 1.3;
    const double expected =
        0.5 + share * (std::cos(alpha) - std::cos(phase)) + share * std::sin(phase) * first * end;
    ASSERT_NEAR(record(scene, 0.25, 0).end.position, expected, 1e-12);
  });
  EXPECT_GT(reversed, 30);
}

}  // namespace
}  // namespace ricochet::carrier_track
