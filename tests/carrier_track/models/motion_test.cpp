#include <boost/math/quadrature/gauss.hpp>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

/// What holds of every motion, shown on thousands of random scenes.
namespace ricochet::carrier_track {
namespace {

constexpr int trials = 3000;

bool rests(const Watched<double>::Stretch& s) {
  return s.flight.harmonics == 0 && s.flight.velocity == 0 && s.flight.steady == 0;
}

void expect_equation_31(const Scene& scene, const Watched<double>::Stretch& s) {
  const double friction = scene.friction * scene.normal_force / scene.mass;
  const double direction = s.flight.at(s.duration / 2).velocity > 0 ? 1 : -1;
  for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    const Motion<double> m = s.flight.at(share * s.duration);
    ASSERT_GE(m.position, scene.wall_lower - 1e-16);
    ASSERT_LE(m.position, scene.wall_upper + 1e-16);
    const double push = force_of_plate(scene, s.time + share * s.duration) / scene.mass;
    if (rests(s)) {
      ASSERT_TRUE(push <= friction + 1e-12 || m.position == scene.wall_upper) << push - friction;
      ASSERT_TRUE(push >= -friction - 1e-12 || m.position == scene.wall_lower) << push + friction;
    } else {
      ASSERT_NEAR(m.acceleration, push - direction * friction, 1e-12);
      ASSERT_GE(direction * m.velocity, -1e-14);
    }
  }
}

TEST(Motion, ObeysEquation31BetweenTheWallsAtAllTimes) {
  for_random(11, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    for (const auto& s : watch(scene).stretches) {
      ASSERT_NO_FATAL_FAILURE(expect_equation_31(scene, s));
    }
  });
}

TEST(Motion, IsContinuousButForTheImpactsItTells) {
  for_random(12, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const auto watched = watch(scene);
    double time = 0;
    double position = scene.start_position;
    double velocity = scene.start_velocity;
    std::size_t hits = 0;
    for (const auto& s : watched.stretches) {
      ASSERT_NEAR(s.time, time, 1e-14);
      ASSERT_GE(s.duration, 0.0);
      ASSERT_NEAR(s.flight.position, position, 1e-15 * (2e-2 + std::abs(position)))
          << "at " << time;
      if (std::abs(s.flight.velocity - velocity) > 1e-15) {
        ASSERT_LT(hits, watched.hits.size());
        const auto& hit = watched.hits[hits++];
        const bool upper = hit.wall == Wall::upper;
        const double rebound =
            (upper ? upper_restitution(scene) : lower_restitution(scene)) * hit.speed;
        ASSERT_EQ(hit.time, s.time);
        ASSERT_NEAR(position, upper ? scene.wall_upper : scene.wall_lower, 2e-17);
        ASSERT_NEAR(velocity, upper ? hit.speed : -hit.speed, 1e-15);
        ASSERT_GT(hit.speed, 0.0);
        const bool stays = rests(s) && rebound <= resting_speed;
        ASSERT_NEAR(s.flight.velocity, stays ? 0.0 : (upper ? -rebound : rebound), 1e-15);
      }
      const Motion<double> m = s.flight.at(s.duration);
      time = s.time + s.duration;
      position = m.position;
      velocity = m.velocity;
    }
    ASSERT_EQ(hits, watched.hits.size());
    ASSERT_NEAR(watched.end.time, duration_of(scene), 1e-14);
    ASSERT_NEAR(watched.end.position, position, 1e-15 * (2e-2 + std::abs(position)));
    ASSERT_NEAR(watched.end.velocity, velocity, 1e-14);
  });
}

TEST(Motion, BalancesItsEnergy) {
  // Kinetic energy = work of the applied force - friction - what the impacts take.
  for_random(13, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const auto watched = watch(scene);
    double energy = 0.5 * scene.mass * scene.start_velocity * scene.start_velocity;
    double turnover = energy;
    for (const auto& s : watched.stretches) {
      const auto power = [&](double t) {
        const double velocity = s.flight.at(t).velocity;
        return force_of_plate(scene, s.time + t) * velocity -
               scene.friction * scene.normal_force * std::abs(velocity);
      };
      const int panels = 1 + static_cast<int>(s.duration * 40);
      for (int k = 0; k < panels; ++k) {
        const double work = boost::math::quadrature::gauss<double, 15>::integrate(
            power, s.duration * k / panels, s.duration * (k + 1) / panels);
        energy += work;
        turnover += std::abs(work);
      }
    }
    for (const auto& hit : watched.hits) {
      const double e =
          hit.wall == Wall::upper ? upper_restitution(scene) : lower_restitution(scene);
      energy -= 0.5 * scene.mass * (1 - e * e) * hit.speed * hit.speed;
    }
    const double left = 0.5 * scene.mass * watched.end.velocity * watched.end.velocity;
    ASSERT_NEAR(left, energy, 1e-12 * turnover + 1e-18);
  });
}

/// The scene seen from the other side: x -> -x.
Scene mirrored(const Scene& scene) {
  Scene mirror = with(scene, set::walls(-scene.wall_upper, -scene.wall_lower),
                      set::start(-scene.start_position, -scene.start_velocity),
                      set::phase(scene.phase + std::numbers::pi),  // turns every force that turns
                      set::disturbance(-scene.disturbance));
  std::swap(mirror.restitution_lower, mirror.restitution_upper);
  if (!scene.pull_rotates) mirror.pull = -scene.pull;
  if (scene.centrifugal == Centrifugal::inward) mirror.centrifugal = Centrifugal::outward;
  if (scene.centrifugal == Centrifugal::outward) mirror.centrifugal = Centrifugal::inward;
  return mirror;
}

TEST(Motion, IsMirroredInAMirroredScene) {
  for_random(14, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    if (!std::isfinite(scene.wall_upper)) return;
    expect_hits(distinct(watch(mirrored(scene)).hits), distinct(watch(scene).hits), 1e-7, 1e-6,
                true);
  });
}

TEST(Motion, GoesOnFromWhereItWasCut) {
  for_random(17, trials, [](RandomScenes& draws) {
    // A disturbance would need a phase to go on with.
    Scene scene = with(draws.next(), set::disturbance_frequency(0.0));
    const double window = duration_of(scene);
    scene.window = Seconds{window};
    const auto whole = distinct(watch(scene).hits);
    const double cut = draws.within(0.1, 0.9) * window;
    scene.window = Seconds{cut};
    const auto first = watch(scene);
    auto parts = distinct(first.hits);
    const Scene rest =
        with(scene, set::start(first.end.position, first.end.velocity),
             set::phase(scene.phase + scene.omega * cut), set::seconds(window - cut));
    for (auto hit : distinct(watch(rest).hits)) {
      hit.time += cut;
      parts.push_back(hit);
    }
    expect_hits(parts, whole, 1e-7, 1e-6);
  });
}

/// With these numbers multiplied.
Scene multiplied(Scene scene, double factor, const std::vector<double Scene::*>& numbers) {
  for (const auto number : numbers) scene.*number *= factor;
  return scene;
}

TEST(Motion, IsTheSameToTheBitForTwiceTheMassUnderTwiceTheForces) {
  for_random(15, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const auto a = watch(scene);
    const auto b = watch(multiplied(
        scene, 2,
        {&Scene::mass, &Scene::pull, &Scene::normal_force, &Scene::centrifugal_mass_radius,
         &Scene::slider_mass_radius, &Scene::disturbance}));
    expect_hits(b.hits, a.hits, 0, 0);
    ASSERT_EQ(a.end.position, b.end.position);
    ASSERT_EQ(a.end.velocity, b.end.velocity);
  });
}

TEST(Motion, KeepsItsTimesInASceneOfAnotherSize) {
  for_random(16, trials, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const auto small = watch(scene).hits;
    const auto large =
        watch(multiplied(scene, 1024,
                         {&Scene::wall_lower, &Scene::wall_upper, &Scene::start_position,
                          &Scene::start_velocity, &Scene::pull, &Scene::normal_force,
                          &Scene::centrifugal_mass_radius, &Scene::slider_mass_radius,
                          &Scene::disturbance}))
            .hits;
    // Bit for bit, until either lets its body rest, at the same speed in metres per second.
    for (std::size_t k = 0; k < std::min(small.size(), large.size()); ++k) {
      if (small[k].speed < 1e-6) break;
      ASSERT_EQ(large[k].time, small[k].time);
      ASSERT_EQ(large[k].speed, 1024 * small[k].speed);
    }
  });
}

Scene with_soft_walls(double stiffness) {
  return with(scene_of(find_case("C4"), exploratory_scene()), set::omega(5),
              set::fidelity(Fidelity::compliant), set::contact_law(ContactLaw::exact_restitution),
              set::stiffness(stiffness));
}

/// Pressed across by the pull's other part, which adds to the normal force.
Scene pressed_across(double pull) {
  return with(with_soft_walls(1e8), set::planar({.pull = pull, .start_position = 1}));
}

TEST(Simulate, FollowsTheFidelityOfTheScene) {
  const auto count_of = [](const Scene& scene) { return record(scene, 0.25, 0).count; };
  const Scene hard = with(with_soft_walls(1e18), set::fidelity(Fidelity::impact));
  const int count = count_of(hard);
  EXPECT_EQ(count_of(with_soft_walls(1e18)), count);
  EXPECT_NE(count_of(with_soft_walls(1e8)), count) << "a soft wall is another machine";
  EXPECT_EQ(count_of(pressed_across(0)), count);
  const Scene pressed = with(hard, set::normal_force(hard.normal_force + 1.5));
  EXPECT_EQ(count_of(pressed_across(1.5)), count_of(pressed));
  EXPECT_NE(count_of(pressed), count);
}

TEST(Simulate, RecordsThePathInACompliantWall) {
  const auto path = record(with_soft_walls(1e10), 0.25, 200).path;
  EXPECT_TRUE(std::ranges::is_sorted(path, {}, &Sample::time));
  EXPECT_LT(std::ranges::min(path, {}, &Sample::position).position, -1e-6);
}

TEST(Simulate, RefusesASceneThatLeavesItsLevelOpen) {
  Scene open = with(with_soft_walls(1e10), set::fidelity(Fidelity::automatic));
  EXPECT_THROW(watch(open), std::invalid_argument);
  open.profile = {{0.0, 2.0}};
  EXPECT_THROW(watch(open), std::invalid_argument);
}

TEST(Simulate, HasNoDerivativesInACompliantWallAndInTwoDirections) {
  EXPECT_THROW(surrogate_slope(with_soft_walls(1e8), 0.25), std::invalid_argument);
  EXPECT_THROW(surrogate_slope(pressed_across(1), 0.25), std::invalid_argument);
}

/// Turning points off the walls, as they are told and as they are seen between stretches: where one
/// led to a wall that was not struck, and the next does not. Those of motions that are lost in
/// rounding are left out.
struct Turns : Observer {
  using Turning = std::vector<std::pair<double, double>>;  // times and positions

  explicit Turns(const Scene& scene) : scene_(scene) {}

  void impact(double /*time*/, Wall wall, double /*speed*/) {
    if (ahead_ == wall) ahead_.reset();
  }

  void turn(double time, double position, Wall ahead) { add(told, time, position, ahead); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (ahead_ && !((*ahead_ == Wall::upper ? 1 : -1) * path.velocity > 0)) {
      add(seen, time, path.position, *ahead_);
    }
    ahead_.reset();
    const double velocity = path.velocity != 0 ? path.velocity : path.at(0.5 * duration).velocity;
    if (velocity != 0) ahead_ = velocity > 0 ? Wall::upper : Wall::lower;
    lost_ = path.at(duration).position == path.position && path.at(1.0).velocity != 0;
  }

  Turning told, seen;

 private:
  void add(Turning& turns, double time, double position, Wall ahead) {
    const double distance =
        ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
    if (distance > 0 && !lost_ && time < duration_of(scene_)) turns.emplace_back(time, position);
  }

  const Scene& scene_;
  std::optional<Wall> ahead_;
  bool lost_ = false;  // whether the last stretch was a flight that led nowhere
};

TEST(Simulate, TellsTheTurningPointsThatStretchesShow) {
  std::map<Fidelity, std::size_t> turns;
  for (int i = 0; i < 2000; ++i) {
    Scene scene = hostile_scene(11, i).scene;
    scene.stiffness = 1e6 * scene.mass;
    scene.across.emplace().pull = i % 7 - 3;
    scene.across->start_velocity = 1;
    for (const Fidelity level : {Fidelity::impact, Fidelity::compliant, Fidelity::planar}) {
      scene.fidelity = level;
      SCOPED_TRACE(i);
      Turns observer(scene);
      try {
        simulate(scene, observer);
      } catch (const std::runtime_error&) {  // too long
        continue;
      }
      ASSERT_EQ(observer.told, observer.seen);
      turns[level] += observer.told.size();
    }
  }
  EXPECT_EQ(turns.size(), 3U);
  for (const auto& [level, told] : turns) EXPECT_GT(told, 1000U);
}

/// Below, hops are shorter than a step of the brute force, and each side ends a Zeno sequence at
/// its own speed.
constexpr double slowest_compared = 1e-6;  // [m/s]

/// How far the models and the brute force agree over many scenes.
struct Agreement {
  std::size_t listed = 0;           ///< impacts of the brute force
  std::vector<double> time_errors;  ///< [s], of those compared
  int certain = 0;                  ///< scenes whose count is certain
};

/// Compares a scene with the brute force at two steps, one four times the other. Their difference
/// is by theory fifteen times the error of the finer one, and serves as the bar; impacts count
/// until it grows beyond 0.1 ms, where the path is lost.
void compare(const Scene& scene, double step, Agreement& agreement) {
  const Recording model = record(scene, 0.25, 0);
  const BruteForce fine(scene, step);
  const std::vector<Impact> reference = faster(fine.impacts, slowest_compared);
  const std::vector<Impact> coarse = faster(BruteForce(scene, 4 * step).impacts, slowest_compared);
  const std::vector<Impact> actual = faster(model.impacts, slowest_compared);
  // The bars' floors are what the hops too slow to be followed may take.
  double time_bar = 1e-8;
  double speed_bar = 1e-8;
  std::size_t k = 0;
  for (; k < std::min(reference.size(), coarse.size()); ++k) {
    const double difference = std::abs(reference[k].time - coarse[k].time);
    if (reference[k].wall != coarse[k].wall || difference > 1e-4) break;
    time_bar = std::max(time_bar, difference);
    speed_bar = std::max(speed_bar, std::abs(reference[k].speed - coarse[k].speed));
    ASSERT_LT(k, actual.size()) << "an impact is missing";
    ASSERT_EQ(actual[k].wall, reference[k].wall) << "impact " << k;
    ASSERT_NEAR(actual[k].time, reference[k].time, time_bar) << "impact " << k;
    ASSERT_NEAR(actual[k].speed, reference[k].speed, speed_bar) << "impact " << k;
    agreement.time_errors.push_back(std::abs(actual[k].time - reference[k].time));
  }
  if (k == reference.size() && k == coarse.size()) {
    EXPECT_EQ(actual.size(), k) << "an impact too many";
    EXPECT_NEAR(model.end.position, fine.position, 1e-6);
  }
  agreement.listed += reference.size();
  if (!model.certainty.certain) return;
  ++agreement.certain;
  EXPECT_EQ(model.count, std::ssize(faster(fine.impacts, scene.counting_limit)));
}

TEST(BruteForce, FindsTheImpactsOfRandomScenes) {
  Agreement agreement;
  for_random(1, 400, [&](RandomScenes& draws) { compare(draws.next(), 1e-5, agreement); });
  auto& errors = agreement.time_errors;
  EXPECT_GT(agreement.listed, 6000U);
  EXPECT_GT(errors.size(), agreement.listed * 95 / 100);
  EXPECT_GT(agreement.certain, 390);
  std::ranges::nth_element(errors, errors.begin() + std::ssize(errors) / 2);
  EXPECT_LT(errors[errors.size() / 2], 1e-9);
}

TEST(BruteForce, ConvergesWithTheSquareOfItsStep) {
  // What makes it a reference: the bars above rest on this order.
  double coarse = 0, fine = 0;
  for_random(3, 40, [&](RandomScenes& draws) {
    const Scene scene = with(draws.next(), set::friction(0), set::restitution(0.5));
    const double exact = record(scene, 0.25, 0).end.position;
    coarse += std::abs(BruteForce(scene, 4e-4).position - exact);
    fine += std::abs(BruteForce(scene, 1e-4).position - exact);
  });
  EXPECT_NEAR(std::log2(coarse / fine) / 2, 2.0, 0.5);
}

TEST(PlanarBruteForce, BruteForceFindsTheImpactsOfRandomScenes) {
  Agreement agreement;
  for_random(41, 100, [&](RandomScenes& draws) { compare(draws.next_planar(), 1e-5, agreement); });
  EXPECT_GT(agreement.listed, 1000U);
  EXPECT_GT(agreement.time_errors.size(), agreement.listed * 95 / 100);
  EXPECT_GT(agreement.certain, 95);
}

}  // namespace
}  // namespace ricochet::carrier_track
