#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/watch.h"

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
  RandomScenes scenes(11);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
    for (const auto& s : watch(scene).stretches) {
      ASSERT_NO_FATAL_FAILURE(expect_equation_31(scene, s));
    }
  }
}

TEST(Motion, IsContinuousButForTheImpactsItTells) {
  RandomScenes scenes(12);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
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
  }
}

TEST(Motion, BalancesItsEnergy) {
  // Kinetic energy = work of the applied force - friction - what the impacts take.
  RandomScenes scenes(13);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
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
  }
}

/// The scene seen from the other side: x -> -x.
Scene mirrored(const Scene& scene) {
  Scene mirror = scene;
  mirror.wall_lower = -scene.wall_upper;
  mirror.wall_upper = -scene.wall_lower;
  std::swap(mirror.restitution_lower, mirror.restitution_upper);
  mirror.start_position = -scene.start_position;
  mirror.start_velocity = -scene.start_velocity;
  mirror.phase = scene.phase + std::numbers::pi;  // turns every force that turns
  if (!scene.pull_rotates) mirror.pull = -scene.pull;
  if (scene.centrifugal == Centrifugal::inward) mirror.centrifugal = Centrifugal::outward;
  if (scene.centrifugal == Centrifugal::outward) mirror.centrifugal = Centrifugal::inward;
  mirror.disturbance = -scene.disturbance;
  return mirror;
}

/// Impacts faster than 1e-6 m/s: slower hops may end at another one.
std::vector<Impact> distinct(const Scene& scene) {
  std::vector<Impact> result;
  for (const auto& hit : watch(scene).hits) {
    if (hit.speed > 1e-6) result.push_back({hit.time, hit.wall, hit.speed});
  }
  return result;
}

TEST(Motion, IsMirroredInAMirroredScene) {
  RandomScenes scenes(14);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
    if (!std::isfinite(scene.wall_upper)) continue;
    const auto impacts = distinct(scene);
    const auto images = distinct(mirrored(scene));
    ASSERT_EQ(impacts.size(), images.size());
    for (std::size_t k = 0; k < impacts.size(); ++k) {
      ASSERT_NE(impacts[k].wall, images[k].wall);
      ASSERT_NEAR(impacts[k].time, images[k].time, 1e-7);
      ASSERT_NEAR(impacts[k].speed, images[k].speed, 1e-6);
    }
  }
}

TEST(Motion, IsTheSameToTheBitForTwiceTheMassUnderTwiceTheForces) {
  RandomScenes scenes(15);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
    Scene heavy = scene;
    heavy.mass *= 2;
    heavy.pull *= 2;
    heavy.normal_force *= 2;
    heavy.centrifugal_mass_radius *= 2;
    heavy.slider_mass_radius *= 2;
    heavy.disturbance *= 2;
    const auto a = watch(scene);
    const auto b = watch(heavy);
    ASSERT_EQ(a.hits.size(), b.hits.size());
    ASSERT_EQ(a.end.position, b.end.position);
    ASSERT_EQ(a.end.velocity, b.end.velocity);
  }
}

TEST(Motion, KeepsItsTimesInASceneOfAnotherSize) {
  RandomScenes scenes(16);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next();
    Scene large = scene;
    constexpr double factor = 1024;
    for (double* quantity :
         {&large.wall_lower, &large.wall_upper, &large.start_position, &large.start_velocity,
          &large.pull, &large.normal_force, &large.centrifugal_mass_radius,
          &large.slider_mass_radius, &large.disturbance}) {
      *quantity *= factor;
    }
    const auto small_hits = watch(scene).hits;
    const auto large_hits = watch(large).hits;
    // Bit for bit, until either lets its body rest, at the same speed in metres per second.
    for (std::size_t k = 0; k < std::min(small_hits.size(), large_hits.size()); ++k) {
      if (small_hits[k].speed < 1e-6) break;
      ASSERT_EQ(large_hits[k].time, small_hits[k].time);
      ASSERT_EQ(large_hits[k].speed, factor * small_hits[k].speed);
    }
  }
}

TEST(Motion, GoesOnFromWhereItWasCut) {
  RandomScenes scenes(17);
  for (int i = 0; i < trials; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next();
    scene.disturbance_frequency = 0.0;  // else it would need a phase to go on with
    const double window = duration_of(scene);
    scene.window = Seconds{window};
    const auto whole = distinct(scene);
    const double cut = scenes.within(0.1, 0.9) * window;
    scene.window = Seconds{cut};
    const auto first = watch(scene);
    auto parts = distinct(scene);
    scene.start_position = first.end.position;
    scene.start_velocity = first.end.velocity;
    scene.phase += scene.omega * cut;
    scene.window = Seconds{window - cut};
    for (Impact impact : distinct(scene)) {
      impact.time += cut;
      parts.push_back(impact);
    }
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k) {
      ASSERT_EQ(parts[k].wall, whole[k].wall);
      ASSERT_NEAR(parts[k].time, whole[k].time, 1e-7);
      ASSERT_NEAR(parts[k].speed, whole[k].speed, 1e-6);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
