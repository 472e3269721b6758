#include "problems/carrier_track/gradients/derivatives.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "src/core/difference.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// A speed profile that has no say in forces that do not turn, or none.
template <class Scalar>
std::vector<SpeedKnot<Scalar>> idle_profile(bool profiled) {
  if (!profiled) return {};
  return {{0.1, constant<Scalar>(2)}, {1.0, constant<Scalar>(7)}, {2.5, constant<Scalar>(1)}};
}

// A ball of unit mass that falls on the lower wall: x is gravity g, restitution e and height h.

constexpr std::size_t the_end = 1000;  // the number of the impact where its bouncing has ended

/// Time or speed of its impact number k, from 0.
auto ball(std::size_t k, bool time, bool profiled) {
  return [=]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
    BasicScene<Scalar> scene;
    scene.wall_upper = constant<Scalar>(infinity);
    scene.pull = x[0];
    scene.restitution_lower = x[1];
    scene.start_position = x[2];
    scene.window = Seconds{40.0};
    scene.profile = idle_profile<Scalar>(profiled);
    const auto watched = watch(scene);
    if (k == the_end) return watched.stretches.back().time;
    return time ? watched.hits.at(k).time : watched.hits.at(k).speed;
  };
}

/// The same in closed form: sqrt(2 h / g) (1 + 2 (e + ... + e^k)) and sqrt(2 h g) e^k.
auto ball_in_closed_form(std::size_t k, bool time) {
  return [=]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
    using std::sqrt;
    const Scalar &g = x[0], &e = x[1], &h = x[2];
    const Scalar one = constant<Scalar>(1), two = constant<Scalar>(2);
    Scalar power = one;
    Scalar sum = one;
    for (std::size_t i = 0; i < k; ++i) sum += two * (power *= e);
    return time ? sqrt(two * h / g) * sum : sqrt(two * h * g) * power;
  };
}

TEST(Derivatives, OfABouncingBallAreThoseOfItsClosedForm) {
  const Vector x{{9.8, 0.8, 20.0}};
  for (const bool profiled : {false, true}) {
    for (const bool time : {false, true}) {
      for (const std::size_t k : {1UL, 2UL, 5UL, 20UL, the_end}) {
        if (k == the_end && (profiled || !time)) continue;
        SCOPED_TRACE(std::to_string(k) + (time ? " time" : " speed") +
                     (profiled ? " profile" : ""));
        const auto f = ball(k, time, profiled);
        const Hessian exact = hessian_of(ball_in_closed_form(k, time), x);
        const Gradient gradient = gradient_of(f, x, Vector::Ones(3));
        const Hessian hessian = hessian_of(f, x);
        EXPECT_NEAR(gradient.value / exact.value, 1, 1e-14);
        EXPECT_NEAR(hessian.value / exact.value, 1, 1e-14);
        EXPECT_NEAR(value_of(f, x) / exact.value, 1, 1e-14);
        const double size = exact.gradient.cwiseAbs().maxCoeff();
        EXPECT_LT((gradient.gradient - exact.gradient).cwiseAbs().maxCoeff(), 1e-13 * size);
        EXPECT_LT((hessian.gradient - exact.gradient).cwiseAbs().maxCoeff(), 1e-13 * size);
        EXPECT_LT((hessian.hessian - exact.hessian).cwiseAbs().maxCoeff(),
                  1e-13 * exact.hessian.cwiseAbs().maxCoeff());
        EXPECT_EQ(hessian.hessian, hessian.hessian.transpose());
      }
    }
  }
}

TEST(Derivatives, AreThereWhereAWallReturnsNothing) {
  // Thrown down at 1 m/s from 1/2 m against a force of 1/2 m/s^2, which then lifts it off the wall:
  // x = e v s + s^2 / 4 at s after the impact at speed v.
  const double time = 2 - std::sqrt(2.0);
  const double speed = 1 - time / 2;
  for (const bool profiled : {false, true}) {
    const auto f = [&]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
      BasicScene<Scalar> scene;
      scene.wall_upper = constant<Scalar>(100.0);
      scene.restitution_lower = x[0];
      scene.pull = constant<Scalar>(-0.5);
      scene.start_velocity = constant<Scalar>(-1.0);
      scene.window = Seconds{3.0};
      scene.profile = idle_profile<Scalar>(profiled);
      return watch(scene).end.position;
    };
    const Gradient gradient = gradient_of(f, Vector{{0.0}}, Vector::Ones(1));
    EXPECT_NEAR(gradient.value, (3 - time) * (3 - time) / 4, 1e-14);
    EXPECT_NEAR(gradient.gradient[0], speed * (3 - time), 1e-14);
  }
}

TEST(Derivatives, WithRespectToTheStartAreAProductOfSaltationMatrices) {
  // Without friction every flight takes (x, v) on by [[1, t], [0, 1]], and an impact at velocity v
  // under the force a by [[-e, 0], [-(1 + e) a / v, -e]]: the saltation matrix of a bounce.
  RandomScenes draws(1);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Scene scene =
        with(draws.next(), set::friction(0), set::start_velocity(draws.within(0.01, 0.1)),
             set::restitution_lower(draws.within(0.5, 1.0)),
             set::restitution_upper(draws.within(0.5, 1.0)), set::seconds(draws.within(0.05, 0.2)));
    scene.start_position = 0.4 * scene.wall_lower + 0.6 * std::min(scene.wall_upper, 1.0);
    if (i % 2 == 1) {
      scene.profile = {{0.02, scene.omega}, {0.06, 1.5 * scene.omega}, {0.1, 0.5 * scene.omega}};
    }
    const Watched<double> plain = watch(scene);
    Matrix path = Matrix::Identity(2, 2);
    double now = 0;
    bool tame = true;
    const auto fly_to = [&](double time) {
      path = Matrix{{1, time - now}, {0, 1}} * path;
      now = time;
    };
    for (const auto& hit : plain.hits) {
      fly_to(hit.time);
      const bool upper = hit.wall == Wall::upper;
      const double e = upper ? scene.restitution_upper : scene.restitution_lower;
      const double v = upper ? hit.speed : -hit.speed;
      const double a = force_of_plate(scene, hit.time) / scene.mass;
      tame = tame && hit.speed > 1e-3;
      path = Matrix{{-e, 0}, {(1 + e) * a / v, -e}} * path;
    }
    fly_to(plain.end.time);
    if (!tame || plain.hits.empty()) continue;
    const Vector x{{scene.start_position, scene.start_velocity}};
    for (const bool velocity : {false, true}) {
      const auto end = [&]<class Scalar>(std::span<const Scalar> at, auto& /*watch*/) {
        auto near = lifted<Scalar>(scene);
        near.start_position = at[0];
        near.start_velocity = at[1];
        Observer nobody;
        const End<Scalar> last = simulate(near, nobody);
        return velocity ? last.velocity : last.position;
      };
      const Vector expected = path.row(velocity);
      const Vector exact = gradient_of(end, x, Vector::Ones(2)).gradient;
      EXPECT_LT((exact - expected).norm(), 1e-9 * path.norm()) << plain.hits.size();
    }
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

/// Where the constants of a scene that have derivatives are, the knots last.
template <class Scalar>
std::vector<Scalar*> constants_of(BasicScene<Scalar>& scene) {
  std::vector<Scalar*> result;
  for (Scalar* each :
       {&scene.mass, &scene.wall_lower, &scene.wall_upper, &scene.restitution_lower,
        &scene.restitution_upper, &scene.friction, &scene.normal_force, &scene.pull,
        &scene.pull_phase, &scene.centrifugal_mass_radius, &scene.slider_mass_radius, &scene.phase,
        &scene.disturbance, &scene.disturbance_frequency, &scene.disturbance_phase,
        &scene.start_position, &scene.start_velocity, &scene.counting_limit, &scene.omega}) {
    result.push_back(each);
  }
  for (auto& knot : scene.profile) result.push_back(&knot.omega);
  return result;
}

/// A smooth function of all constants: the surrogate, where the path ends, and when.
auto outcome_of(const Scene& scene) {
  return [&scene]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
    auto near = lifted<Scalar>(scene);
    const auto constants = constants_of(near);
    for (std::size_t i = 0; i < constants.size(); ++i) *constants[i] = x[i];
    Scalar count = constant<Scalar>(0.0);
    auto add = [&](const Scalar& z, const Scalar& left) { count += weight(z, left, 0.25); };
    Features<Scalar, decltype(add)> features(near, add);
    const End<Scalar> end = simulate(near, features);
    return count + constant<Scalar>(1e3) * end.position + end.velocity + end.time;
  };
}

Vector values_of(Scene scene) {
  const auto constants = constants_of(scene);
  Vector x(static_cast<Eigen::Index>(constants.size()));
  std::ranges::transform(constants, x.begin(), [](const double* each) { return *each; });
  return x;
}

/// The outcome with 19 digits along one constant.
template <class Function>
auto along(const Function& f, const Vector& x, Eigen::Index i) {
  return [&f, x, i](long double at) {
    std::vector<long double> all(x.begin(), x.end());
    all[static_cast<std::size_t>(i)] = at;
    Unwatched nobody;
    return f(std::span<const long double>(all), nobody);
  };
}

/// Random scenes whose constants are all within what is allowed, with a profile or none.
Scene inner_scene(RandomScenes& draws, bool profiled) {
  Scene scene = draws.next();
  const double gap = std::min(scene.wall_upper - scene.wall_lower, 5e-3);
  scene.wall_upper = scene.wall_lower + gap;
  scene.start_position = scene.wall_lower + gap * draws.within(0.1, 0.9);
  scene.restitution_lower = draws.within(0.1, 0.9);
  scene.restitution_upper = draws.within(0.1, 0.9);
  if (scene.friction == 0) scene.friction = 0.1;
  if (scene.start_velocity == 0) scene.start_velocity = 0.05;
  if (scene.pull == 0) scene.pull = 0.3;
  if (profiled) {
    double time = draws.chance(0.5) ? 0.0 : draws.within(0.0, 0.3);
    const int knots = draws.chance(0.3) ? 1 : 4;
    for (int k = 0; k < knots; ++k) {
      scene.profile.push_back({time, scene.omega * draws.within(0.3, 1.7)});
      time += draws.within(0.05, 0.4);
    }
  }
  return scene;
}

/// Compares entries of gradients in random scenes, `entries` each, with what differences know to
/// 1e-9. Returns how many those are.
int compare_with_differences(std::uint64_t seed, int scenes, bool profiled, int entries) {
  int compared = 0;
  for_random(seed, scenes, [&](RandomScenes& draws) {
    const Scene scene = inner_scene(draws, profiled);
    const auto f = outcome_of(scene);
    const Vector x = values_of(scene);
    const Gradient exact = gradient_of(f, x, Vector::Ones(x.size()));
    for (int k = 0; k < entries; ++k) {
      const int i = draws.below(static_cast<int>(x.size()));
      const double h = 1e-6 * (x[i] == 0 ? 1 : std::abs(x[i]));
      const Difference slope =
          difference<>(along(f, x, i), static_cast<long double>(x[i]), static_cast<long double>(h));
      const double size = std::abs(slope.slope) + 1e-3;
      if (!(slope.error < 1e-9 * size)) continue;  // a kink is near
      ++compared;
      ASSERT_NEAR(exact.gradient[i], slope.slope, 2e-8 * size)
          << "constant " << i << ", +- " << slope.error;
    }
  });
  return compared;
}

TEST(Derivatives, AreThoseOfDifferencesWithMoreDigitsForEveryConstant) {
  EXPECT_GT(compare_with_differences(2, 60, false, 4), 180);
}

TEST(Derivatives, AreThoseOfDifferencesWithMoreDigitsForEveryConstantAndKnotOfAProfile) {
  EXPECT_GT(compare_with_differences(3, 30, true, 2), 45);
}

/// A scene in which everything acts, but what is then set to zero.
Scene full_scene(bool profiled) {
  Scene scene = with(exploratory_scene(), set::restitution_lower(0.6), set::restitution_upper(0.5),
                     set::friction(0.1), set::pull_rotates(true), set::pull_phase(0.4),
                     set::slider_mass_radius(0.02), set::disturbance(0.3),
                     set::disturbance_frequency(40), set::disturbance_phase(0.7), set::omega(5));
  if (profiled) scene.profile = {{0.1, 3.0}, {0.4, 7.0}, {0.6, 5.0}};
  return scene;
}

TEST(Derivatives, AreThereWhereAConstantIsZero) {
  for (const bool profiled : {false, true}) {
    for (const auto zero :
         {&Scene::friction, &Scene::normal_force, &Scene::pull, &Scene::pull_phase,
          &Scene::centrifugal_mass_radius, &Scene::slider_mass_radius, &Scene::phase,
          &Scene::disturbance, &Scene::disturbance_frequency, &Scene::disturbance_phase,
          &Scene::wall_lower, &Scene::omega}) {
      Scene scene = full_scene(profiled);
      scene.*zero = 0;
      const bool speed = zero == &Scene::omega;
      if (speed) scene.window = Seconds{0.8};
      if (speed && profiled) scene.profile.front().omega = 0;
      Scene marked = scene;
      std::vector<double*> constants = constants_of(marked);
      double* mark = speed && profiled ? &marked.profile.front().omega : &(marked.*zero);
      const auto i = std::ranges::find(constants, mark) - constants.begin();
      SCOPED_TRACE(testing::Message() << "constant " << i << (profiled ? " in a profile" : ""));
      const auto f = outcome_of(scene);
      const Vector x = values_of(scene);
      const double exact = gradient_of(f, x, Vector::Ones(x.size())).gradient[i];
      const Difference slope = one_sided_difference(along(f, x, i), 0.0L, 1e-6L);
      EXPECT_GT(std::abs(slope.slope), 1e-6);
      EXPECT_NEAR(exact / slope.slope, 1, 1e-8) << slope.slope << " +- " << slope.error;
    }
  }
}

TEST(Derivatives, OfABodyAtRestAreThoseOfTheWayItIsPushed) {
  for (const bool profiled : {false, true}) {
    const Scene scene = with(full_scene(profiled), set::start_velocity(0));
    const auto f = outcome_of(scene);
    const Vector x = values_of(scene);
    const Eigen::Index velocity = 16;
    // It sets out at once.
    const double push = force_of_plate(scene, 0);
    ASSERT_GT(std::abs(push), scene.friction * scene.normal_force);
    const Difference slope =
        one_sided_difference(along(f, x, velocity), 0.0L, push > 0 ? 1e-6L : -1e-6L);
    EXPECT_NEAR(gradient_of(f, x, x).gradient[velocity] / slope.slope, 1, 1e-8);
  }
  // Friction that holds a body takes all its speed away.
  Scene scene = with(full_scene(false), set::start_velocity(0));
  scene.friction = 1.01 * std::abs(force_of_plate(scene, 0)) / scene.normal_force;
  const auto f = outcome_of(scene);
  const Vector x = values_of(scene);
  const Gradient held = gradient_of(f, x, x);
  EXPECT_EQ(held.gradient[16], 0);
  const Difference frequency = difference<>(along(f, x, 13), 40.0L, 1e-4L);
  EXPECT_GT(std::abs(frequency.slope), 1e-3);  // it moves later
  EXPECT_NEAR(held.gradient[13], frequency.slope, 1e-8 * std::abs(frequency.slope));
}

TEST(Derivatives, LeaveOutAnInfiniteOne) {
  // All of the restitution is lost to friction 1 in contact: sqrt((1 - f) / (1 + f)).
  const Scene scene = with(full_scene(false), set::contact_friction(true), set::friction(1),
                           set::normal_force(0.1));
  const Vector x = values_of(scene);
  EXPECT_TRUE(gradient_of(outcome_of(scene), x, x).gradient.allFinite());
}

TEST(Derivatives, OfTheEndOfAWindowOfRevolutionsFollowTheKnots) {
  struct Window {
    std::vector<SpeedKnot<double>> profile;
    double turns;
  };
  for (const auto& [profile, turns] : {Window{{{0.0, 3.0}}, 0.7},        // one knot
                                       {{{0.5, 3.0}}, 0.1},              // before it
                                       {{{0.5, 3.0}}, 0.9},              // after it
                                       {{{0.0, 2.0}, {0.5, 6.0}}, 0.2},  // on a leg
                                       {{{0.0, 0.0}, {0.5, 6.0}}, 0.2},  // from rest
                                       {{{0.3, 2.0}, {0.5, 6.0}}, 1.3},  // after the last
                                       {{{0.3, 6.0}, {0.5, 0.0}, {0.9, 4.0}}, 0.6}}) {
    SCOPED_TRACE(turns);
    const Scene scene = with(Scene{}, set::profile(profile), set::revolutions(turns));
    const auto f = [&]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
      auto near = lifted<Scalar>(scene);
      for (std::size_t k = 0; k < x.size(); ++k) near.profile[k].omega = x[k];
      Observer nobody;
      return simulate(near, nobody).time;
    };
    Vector x(static_cast<Eigen::Index>(profile.size()));
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = profile[static_cast<std::size_t>(k)].omega;
    const Hessian exact = hessian_of(f, x);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const auto at = static_cast<long double>(x[k]);
      const Difference slope = x[k] == 0 ? one_sided_difference(along(f, x, k), at, 1e-4L)
                                         : difference<>(along(f, x, k), at, 1e-4L);
      EXPECT_NEAR(exact.gradient[k], slope.slope, 1e-11);
      EXPECT_NEAR(gradient_of(f, x, x).gradient[k], slope.slope, 1e-11);
    }
  }
}

/// The derivative of a function with respect to variable j, along variable i, with 19 digits.
template <class Function>
auto slope_along(const Function& f, const Vector& x, Eigen::Index j, Eigen::Index i) {
  return [&f, x, i, j](long double at) {
    using Jet = ceres::Jet<long double, 1>;
    std::vector<Jet> duals;
    for (Eigen::Index k = 0; k < x.size(); ++k) duals.emplace_back(k == i ? at : x[k]);
    duals[static_cast<std::size_t>(j)].v[0] = 1;
    Unwatched nobody;
    return f(std::span<const Jet>(duals), nobody).v[0];
  };
}

TEST(Derivatives, OfSecondOrderAreThoseOfDifferencesOfTheFirst) {
  RandomScenes draws(4);
  int compared = 0;
  for (int n = 0; n < 12 && !HasFailure(); ++n) {
    SCOPED_TRACE(n);
    const Scene scene = inner_scene(draws, n % 2 == 1);
    const auto f = outcome_of(scene);
    const Vector x = values_of(scene);
    const Hessian exact = hessian_of(f, x);
    EXPECT_EQ(exact.hessian, exact.hessian.transpose());
    EXPECT_LT((exact.gradient - gradient_of(f, x, x).gradient).norm(),
              1e-10 * exact.gradient.norm());
    for (int k = 0; k < 4; ++k) {
      const int i = draws.below(static_cast<int>(x.size()));
      const int j = draws.below(static_cast<int>(x.size()));
      const auto h = static_cast<long double>(1e-6 * (x[i] == 0 ? 1 : std::abs(x[i])));
      const Difference slope =
          difference<>(slope_along(f, x, j, i), static_cast<long double>(x[i]), h);
      const double size = std::abs(slope.slope) + 1e-3;
      if (!(slope.error < 1e-8 * size)) continue;  // a kink is near
      EXPECT_NEAR(exact.hessian(i, j), slope.slope, 1e-7 * size) << i << " " << j;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30);
}

TEST(Derivatives, DoNotMindHowManyVariablesThereAre) {
  // More knots than a block has room for.
  Scene scene = with(full_scene(false), set::seconds(0.4));
  for (int k = 0; k < 21; ++k) scene.profile.push_back({0.015 * k, 5 + std::sin(k)});
  const auto f = outcome_of(scene);
  const Vector x = values_of(scene);
  const Hessian exact = hessian_of(f, x);
  const Gradient gradient = gradient_of(f, x, x);
  EXPECT_LT((exact.gradient - gradient.gradient).norm(), 1e-10 * gradient.gradient.norm());
  for (const Eigen::Index i : {3, 35}) {
    for (const Eigen::Index j : {0, 21, 30}) {
      const Difference slope = difference<>(slope_along(f, x, j, i), static_cast<long double>(x[i]),
                                            static_cast<long double>(1e-6 * std::abs(x[i])));
      EXPECT_NEAR(exact.hessian(i, j), slope.slope, 1e-7 * (1e-3 + std::abs(slope.slope)))
          << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
