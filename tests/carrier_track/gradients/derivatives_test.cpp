#include "problems/carrier_track/gradients/derivatives.h"

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/difference.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// A speed profile that has no say in forces that do not turn.
const std::vector<SpeedKnot<double>> idle_profile = {{0.1, 2}, {1.0, 7}, {2.5, 1}};

// A ball of unit mass that falls on the lower wall: x is gravity g, restitution e and height h.

constexpr std::size_t the_end = 1000;  // the number of the impact where its bouncing has ended

/// Time or speed of its impact number k, from 0.
auto ball(std::size_t k, bool time, bool profiled) {
  Scene scene = with(Scene{}, set::wall_upper(infinity), set::seconds(40));
  if (profiled) scene.profile = idle_profile;
  return [=]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
    auto falling = lifted<Scalar>(scene);
    falling.pull = x[0];
    falling.restitution_lower = x[1];
    falling.start_position = x[2];
    const auto watched = watch(falling);
    if (k == the_end) return watched.stretches.back().time;
    return time ? watched.hits.at(k).time : watched.hits.at(k).speed;
  };
}

/// The same in closed form: sqrt(2 h / g) (1 + 2 (e + ... + e^k)) and sqrt(2 h g) e^k.
auto ball_in_closed_form(std::size_t k, bool time) {
  return [=]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
    using std::sqrt;
    const Scalar &g = x[0], &e = x[1], &h = x[2];
    const Scalar two = constant<Scalar>(2);
    Scalar power = constant<Scalar>(1), sum = power;
    for (std::size_t i = 0; i < k; ++i) sum += two * (power *= e);
    return time ? sqrt(two * h / g) * sum : sqrt(two * h * g) * power;
  };
}

/// Expects no entry to be off by more than this share of the largest one.
void expect_entries(const Matrix& found, const Matrix& exact, double share) {
  EXPECT_LT((found - exact).cwiseAbs().maxCoeff(), share * exact.cwiseAbs().maxCoeff());
}

TEST(Derivatives, OfABouncingBallAreThoseOfItsClosedForm) {
  const Vector x{{9.8, 0.8, 20.0}};
  for (const bool profiled : {false, true}) {
    for (const bool time : {false, true}) {
      for (const std::size_t k : {1UL, 2UL, 5UL, 20UL, the_end}) {
        if (k == the_end && (profiled || !time)) continue;
        SCOPED_TRACE(fmt::format("impact {}, time {}, profile {}", k, time, profiled));
        const auto f = ball(k, time, profiled);
        const Hessian exact = hessian_of(ball_in_closed_form(k, time), x);
        const Gradient gradient = gradient_of(f, x, Vector::Ones(3));
        const Hessian hessian = hessian_of(f, x);
        for (const double value : {gradient.value, hessian.value, value_of(f, x)}) {
          EXPECT_NEAR(value / exact.value, 1, 1e-14);
        }
        expect_entries(gradient.gradient, exact.gradient, 1e-13);
        expect_entries(hessian.gradient, exact.gradient, 1e-13);
        expect_entries(hessian.hessian, exact.hessian, 1e-13);
        EXPECT_EQ(hessian.hessian, hessian.hessian.transpose());
      }
    }
  }
}

TEST(Derivatives, AreThereWhereAWallReturnsNothing) {
  // Thrown down at 1 m/s from 1/2 m against a force of 1/2 m/s^2, which then lifts it off the wall:
  // x = e v s + s^2 / 4 at s after the impact at speed v.
  const double time = 2 - std::sqrt(2.0);
  for (const bool profiled : {false, true}) {
    Scene scene = with(Scene{}, set::wall_upper(100), set::restitution_lower(0), set::pull(-0.5),
                       set::start_velocity(-1), set::seconds(3));
    if (profiled) scene.profile = idle_profile;
    const auto f = [&]<class Scalar>(std::span<const Scalar> x, auto& /*watch*/) {
      auto near = lifted<Scalar>(scene);
      near.restitution_lower = x[0];
      return watch(near).end.position;
    };
    const Gradient gradient = gradient_of(f, Vector{{0.0}}, Vector::Ones(1));
    EXPECT_NEAR(gradient.value, (3 - time) * (3 - time) / 4, 1e-14);
    EXPECT_NEAR(gradient.gradient[0], (1 - time / 2) * (3 - time), 1e-14);
  }
}

/// Without friction every flight takes (x, v) on by [[1, t], [0, 1]], and an impact at velocity v
/// under the force a by [[-e, 0], [-(1 + e) a / v, -e]]: the saltation matrix of a bounce.
TEST(Derivatives, WithRespectToTheStartAreAProductOfSaltationMatrices) {
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
      path = Matrix{{-e, 0}, {(1 + e) * a / v, -e}} * path;
    }
    fly_to(plain.end.time);
    const auto is_slow = [](const auto& hit) { return hit.speed <= 1e-3; };
    if (plain.hits.empty() || std::ranges::any_of(plain.hits, is_slow)) continue;
    const Vector x{{scene.start_position, scene.start_velocity}};
    for (const bool velocity : {false, true}) {
      const auto end = [&]<class Scalar>(std::span<const Scalar> at, auto& /*watch*/) {
        auto near = lifted<Scalar>(scene);
        near.start_position = at[0];
        near.start_velocity = at[1];
        const auto last = watch(near).end;
        return velocity ? last.velocity : last.position;
      };
      const Vector exact = gradient_of(end, x, Vector::Ones(2)).gradient;
      EXPECT_LT((exact - path.row(velocity).transpose()).norm(), 1e-9 * path.norm());
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

/// Its derivative with respect to variable j, along variable i.
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

/// The slope of such a function at x, by differences of a millionth of x.
template <class Along>
Difference slope_at(const Along& f, double x) {
  return difference(f, static_cast<long double>(x), 1e-6L * (x == 0 ? 1 : std::abs(x)));
}

/// Random scenes of either rule whose constants are all within what is allowed, with a profile or
/// none.
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
  if (draws.chance(0.3)) {
    scene.rule = CountRule::peaks;
    scene.peak_high = scene.wall_lower + 0.7 * gap;
    scene.peak_low = scene.wall_lower + 0.3 * gap;
  }
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

TEST(Derivatives, AreThoseOfDifferencesWithMoreDigitsForEveryConstantAndKnotOfAProfile) {
  for (const bool profiled : {false, true}) {
    int compared = 0;
    for_random(profiled ? 3 : 2, profiled ? 30 : 60, [&](RandomScenes& draws) {
      const Scene scene = inner_scene(draws, profiled);
      const auto f = outcome_of(scene);
      const Vector x = values_of(scene);
      const Gradient exact = gradient_of(f, x, Vector::Ones(x.size()));
      for (int k = 0; k < (profiled ? 2 : 4); ++k) {
        const int i = draws.below(static_cast<int>(x.size()));
        const Difference slope = slope_at(along(f, x, i), x[i]);
        const double size = std::abs(slope.slope) + 1e-3;
        if (!(slope.error < 1e-9 * size)) continue;  // a kink is near
        ++compared;
        ASSERT_NEAR(exact.gradient[i], slope.slope, 2e-8 * size)
            << "constant " << i << ", +- " << slope.error;
      }
    });
    EXPECT_GT(compared, profiled ? 45 : 180);
  }
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
      const bool speed = zero == &Scene::omega;
      if (speed) scene.window = Seconds{0.8};
      double& set_to_zero = speed && profiled ? scene.profile.front().omega : scene.*zero;
      set_to_zero = 0;
      const std::vector<double*> constants = constants_of(scene);
      const auto i = std::ranges::find(constants, &set_to_zero) - constants.begin();
      SCOPED_TRACE(testing::Message() << "constant " << i << (profiled ? " in a profile" : ""));
      const auto f = outcome_of(scene);
      const Vector x = values_of(scene);
      const double exact = gradient_of(f, x, x).gradient[i];
      const Difference slope = one_sided_difference(along(f, x, i), 0.0L, 1e-6L);
      EXPECT_GT(std::abs(slope.slope), 1e-6);
      EXPECT_NEAR(exact / slope.slope, 1, 1e-8) << slope.slope << " +- " << slope.error;
    }
  }
}

TEST(Derivatives, OfABodyAtRestAreThoseOfTheWayItIsPushed) {
  constexpr Eigen::Index frequency = 13, velocity = 16;
  for (const bool profiled : {false, true}) {
    const Scene scene = with(full_scene(profiled), set::start_velocity(0));
    const auto f = outcome_of(scene);
    const Vector x = values_of(scene);
    const double push = force_of_plate(scene, 0);
    ASSERT_GT(std::abs(push), scene.friction * scene.normal_force) << "it must set out at once";
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
  EXPECT_EQ(held.gradient[velocity], 0);
  const Difference slope = difference<>(along(f, x, frequency), 40.0L, 1e-4L);
  EXPECT_GT(std::abs(slope.slope), 1e-3);  // it moves later
  EXPECT_NEAR(held.gradient[frequency], slope.slope, 1e-8 * std::abs(slope.slope));
}

/// All of the restitution is lost to friction 1 in contact: sqrt((1 - f) / (1 + f)).
TEST(Derivatives, LeaveOutAnInfiniteOne) {
  const Scene scene = with(full_scene(false), set::contact_friction(true), set::friction(1),
                           set::normal_force(0.1));
  const Vector x = values_of(scene);
  EXPECT_TRUE(gradient_of(outcome_of(scene), x, x).gradient.allFinite());
}

TEST(Derivatives, OfTheEndOfAWindowOfRevolutionsFollowTheKnots) {
  using Window = std::pair<std::vector<SpeedKnot<double>>, double>;
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
    const Vector x = values_of(scene).tail(static_cast<Eigen::Index>(profile.size()));
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

TEST(Derivatives, OfSecondOrderAreThoseOfDifferencesOfTheFirst) {
  int compared = 0;
  bool profiled = true;
  for_random(4, 12, [&](RandomScenes& draws) {
    profiled = !profiled;
    const Scene scene = inner_scene(draws, profiled);
    const auto f = outcome_of(scene);
    const Vector x = values_of(scene);
    const Hessian exact = hessian_of(f, x);
    EXPECT_EQ(exact.hessian, exact.hessian.transpose());
    expect_entries(exact.gradient, gradient_of(f, x, x).gradient, 1e-10);
    for (int k = 0; k < 4; ++k) {
      const int i = draws.below(static_cast<int>(x.size()));
      const int j = draws.below(static_cast<int>(x.size()));
      const Difference slope = slope_at(slope_along(f, x, j, i), x[i]);
      const double size = std::abs(slope.slope) + 1e-3;
      if (!(slope.error < 1e-8 * size)) continue;  // a kink is near
      ASSERT_NEAR(exact.hessian(i, j), slope.slope, 1e-7 * size) << i << " " << j;
      ++compared;
    }
  });
  EXPECT_GT(compared, 30);
}

TEST(Derivatives, DoNotMindHowManyVariablesThereAre) {
  Scene scene = with(full_scene(false), set::seconds(0.4));
  // More knots than a block has room for.
  for (int k = 0; k < 21; ++k) scene.profile.push_back({0.015 * k, 5 + std::sin(k)});
  const auto f = outcome_of(scene);
  const Vector x = values_of(scene);
  const Hessian exact = hessian_of(f, x);
  expect_entries(exact.gradient, gradient_of(f, x, x).gradient, 1e-10);
  for (const Eigen::Index i : {3, 35}) {
    for (const Eigen::Index j : {0, 21, 30}) {
      const Difference slope = slope_at(slope_along(f, x, j, i), x[i]);
      EXPECT_NEAR(exact.hessian(i, j), slope.slope, 1e-7 * (1e-3 + std::abs(slope.slope)))
          << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
