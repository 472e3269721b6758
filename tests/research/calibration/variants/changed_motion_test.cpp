#include "src/research/calibration/variants/changed_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/check/oracle/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/models/impact_model.h"
#include "ricochet/recording.h"
#include "src/research/calibration/variants/speed_restitution.h"
#include "tests/research/calibration/variants/brute_change.h"

namespace ricochet::studies::variants {
namespace {

using namespace carrier_track;

struct Everything : VariantObserver {
  std::vector<Impact> impacts;
  std::vector<Peak> peaks, valleys;

  void impact(double time, Wall wall, double speed) { impacts.push_back({time, wall, speed}); }
  void peak(double time, double position) { peaks.push_back({time, position}); }
  void valley(double time, double position) { valleys.push_back({time, position}); }
};

Everything heard_of(const Scene& scene, const MotionChange& change) {
  Everything heard;
  ChangedMotion(scene, change, resting_speed_of(scene)).run(heard);
  return heard;
}

TEST(ChangedMotion, IsTheImpactModelToTheLastBitWithNothingChanged) {
  RandomScenes scenes(11);
  std::size_t compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = scenes.next();
    Everything expected;
    const auto end = ImpactModel<double>(scene).run(expected);
    Everything heard;
    const MotionChange nothing;
    ChangedMotion motion(scene, nothing, resting_speed_of(scene));
    const auto same = motion.run(heard);
    ASSERT_EQ(heard.impacts.size(), expected.impacts.size()) << i;
    ASSERT_EQ(heard.peaks.size(), expected.peaks.size()) << i;
    for (std::size_t k = 0; k < expected.impacts.size(); ++k) {
      ASSERT_EQ(heard.impacts[k].time, expected.impacts[k].time) << i;
      ASSERT_EQ(heard.impacts[k].speed, expected.impacts[k].speed) << i;
    }
    ASSERT_EQ(same.position, end.position) << i;
    ASSERT_EQ(same.velocity, end.velocity) << i;
    compared += expected.impacts.size();
  }
  EXPECT_GT(compared, 40000U);
}

/// The same body upside down: wall above for wall below, and so on.
Scene turned_over(const Scene& scene) {
  Scene over = scene;
  over.wall_lower = -scene.wall_upper;
  over.wall_upper = -scene.wall_lower;
  std::swap(over.restitution_lower, over.restitution_upper);
  over.pull = -scene.pull;
  if (scene.centrifugal == Centrifugal::projected) {
    over.slider_mass_radius = 2 * scene.centrifugal_mass_radius - scene.slider_mass_radius;
  }
  over.disturbance = -scene.disturbance;
  over.start_position = -scene.start_position;
  over.start_velocity = -scene.start_velocity;
  return over;
}

TEST(ChangedMotion, HasTheValleysThatItsPeaksAreUpsideDown) {
  RandomScenes scenes(12);
  std::size_t compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = scenes.next();
    if (scene.centrifugal != Centrifugal::projected || std::isinf(scene.wall_upper)) continue;
    const Everything up = heard_of(scene, {});
    const Everything down = heard_of(turned_over(scene), {});
    // Rounding parts them in the end.
    const std::size_t first = std::min<std::size_t>({6, up.peaks.size(), down.valleys.size()});
    ASSERT_GE(down.valleys.size(), std::min<std::size_t>(up.peaks.size(), 3)) << i;
    for (std::size_t k = 0; k < first; ++k) {
      EXPECT_NEAR(down.valleys[k].time, up.peaks[k].time, 1e-6) << i;
      EXPECT_NEAR(down.valleys[k].position, -up.peaks[k].position, 1e-8) << i;
    }
    compared += first;
  }
  EXPECT_GT(compared, 200U);
}

/// A body far from any wall, with no force on it.
Scene free_body() {
  Scene scene;
  scene.mass = 2;
  scene.wall_lower = -1e6;
  scene.wall_upper = 1e6;
  scene.start_position = 0;
  scene.omega = 3;
  scene.window = Seconds{2};
  return scene;
}

End<double> end_of(const Scene& scene, const MotionChange& change) {
  VariantObserver nobody;
  return ChangedMotion(scene, change, resting_speed).run(nobody);
}

TEST(ChangedMotion, HoldsAFurtherForceForItsInterval) {
  const Scene scene = free_body();
  MotionChange change;
  change.further_force = HeldForce{0.3, [](std::size_t k) { return k % 2 == 0 ? 4.0 : -1.0; }};
  double x = 0, v = 0;
  for (int k = 0; k < 7; ++k) {  // the last interval ends with the window, after 0.2 s
    const double a = k % 2 == 0 ? 2.0 : -0.5, t = k < 6 ? 0.3 : 0.2;
    x += v * t + a * t * t / 2;
    v += a * t;
  }
  EXPECT_NEAR(end_of(scene, change).position, x, 1e-12);
  EXPECT_NEAR(end_of(scene, change).velocity, v, 1e-12);
}

TEST(ChangedMotion, RubsAgainstAShareOfTheForceAlongY) {
  Scene scene = free_body();
  scene.start_velocity = 50;
  scene.friction = 0.4;
  scene.normal_force = 1000;  // of no effect
  scene.slider_mass_radius = 0.5;
  scene.centrifugal_mass_radius = 0.5;  // along x they cancel
  scene.window = Revolutions{1.5};
  MotionChange change;
  change.press = Press{0.7, 0};
  // The size of F sin over three half turns: 2 F / omega each, with F = (0.5 + 0.5) omega^2.
  const double impulse = 3 * 2 * 1.0 * scene.omega;
  EXPECT_NEAR(end_of(scene, change).velocity, 50 - 0.4 * 0.7 * impulse / scene.mass, 1e-10);
  change.press = Press{0.7, 20};  // more than the turning force: it keeps its sign
  const double duration = 3 * std::numbers::pi / scene.omega;
  const double sum = 20 * duration + 2 * 1.0 * scene.omega;
  EXPECT_NEAR(end_of(scene, change).velocity, 50 - 0.4 * 0.7 * sum / scene.mass, 1e-10);
}

TEST(ChangedMotion, ReturnsWhatTheSpeedOfEachImpactSays) {
  Scene scene;  // no force: each approach has the speed of the last rebound
  scene.start_velocity = 4;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.friction = 0.6;
  scene.contact_friction = true;
  scene.window = Seconds{30};
  MotionChange change;
  change.restitution = [](double speed, double e) { return speed_restitution(e, speed, 2.0); };
  const Everything heard = heard_of(scene, change);
  ASSERT_GE(heard.impacts.size(), 4U);
  double speed = 4;
  for (const Impact& impact : heard.impacts) {
    EXPECT_NEAR(impact.speed, speed, 1e-12);
    speed *= 0.5 * (1 - 0.5 * std::pow(speed / 2, 0.2));  // sqrt(0.4 / 1.6) for friction
  }
}

/// How many impacts were compared with the brute force, up to where that is lost itself.
std::size_t compared_with_brute_force(const Scene& scene, const MotionChange& change,
                                      const BruteChanges& changes, double step) {
  const auto fast = [](std::vector<Impact> impacts) {
    std::erase_if(impacts, [](const Impact& impact) { return impact.speed < 1e-5; });
    return impacts;
  };
  const auto fine = fast(brute_change(scene, changes, step));
  const auto coarse = fast(brute_change(scene, changes, 4 * step));
  const auto actual = fast(heard_of(scene, change).impacts);
  double bar = 1e-7;
  std::size_t k = 0;
  for (; k < std::min(fine.size(), coarse.size()); ++k) {
    const double apart = std::abs(fine[k].time - coarse[k].time);
    if (fine[k].wall != coarse[k].wall || apart > 1e-4) return k;
    bar = std::max(bar, apart);
    if (k >= actual.size() || actual[k].wall != fine[k].wall ||
        std::abs(actual[k].time - fine[k].time) > bar) {
      ADD_FAILURE() << "impact " << k << " at " << fine[k].time << ", coarse " << coarse[k].time
                    << ", here " << (k < actual.size() ? actual[k].time : -1) << ", bar " << bar;
      return k;
    }
  }
  if (fine.size() == coarse.size()) {
    EXPECT_EQ(actual.size(), fine.size());
  }
  return k;
}

/// A window of 2^14 steps, so that intervals of 2^8 of them are kept to exactly.
Scene short_scene(RandomScenes& scenes, double step) {
  Scene scene = scenes.next();
  scene.window = Seconds{16384 * step};
  return scene;
}

constexpr double brute_step = 0x1p-15;  // [s]

TEST(ChangedMotion, AgreesWithBruteForceOnAHeldForce) {
  RandomScenes scenes(21);
  std::size_t compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = short_scene(scenes, brute_step);
    const double interval = 256 * brute_step;
    const auto height = [i](std::size_t k) {
      return std::sin(1.0 + i + 7.0 * static_cast<double>(k));
    };
    MotionChange change;
    change.further_force = HeldForce{interval, height};
    const auto force = [&](double time) {
      return height(static_cast<std::size_t>(time / interval));
    };
    compared += compared_with_brute_force(scene, change, {force, {}, {}}, brute_step);
  }
  EXPECT_GT(compared, 500U);
}

TEST(ChangedMotion, AgreesWithBruteForceOnAPressThatVaries) {
  RandomScenes scenes(22);
  std::size_t compared = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = short_scene(scenes, brute_step);
    scene.pull_rotates = false;
    MotionChange change;
    change.press = Press{1.5, 0.3};
    const auto normal = [&](double time) {
      const double radius =
          scene.slider_mass_radius +
          (scene.centrifugal == Centrifugal::projected ? scene.centrifugal_mass_radius : 0.0);
      const double along_y =
          0.3 + radius * scene.omega * scene.omega * std::sin(scene.omega * time + scene.phase);
      return 1.5 * std::abs(along_y);
    };
    compared += compared_with_brute_force(scene, change, {{}, normal, {}}, brute_step);
  }
  EXPECT_GT(compared, 300U);
}

TEST(ChangedMotion, AgreesWithBruteForceOnARestitutionBySpeed) {
  RandomScenes scenes(23);
  std::size_t compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = short_scene(scenes, brute_step);
    MotionChange change;
    change.restitution = [](double speed, double e) { return speed_restitution(e, speed, 0.05); };
    compared += compared_with_brute_force(scene, change, {{}, {}, change.restitution}, brute_step);
  }
  EXPECT_GT(compared, 500U);
}

}  // namespace
}  // namespace ricochet::studies::variants
