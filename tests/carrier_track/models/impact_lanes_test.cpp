#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

/// The impacts of a simulation and its end, number by number.
struct ImpactBits : Observer {
  static constexpr bool hears_impacts_alone = true;

  std::vector<std::uint64_t> told;

  void note(double x) { told.push_back(std::bit_cast<std::uint64_t>(x)); }

  void impact(double time, Wall wall, double speed) {
    note(wall == Wall::upper ? 1 : -1);
    note(time);
    note(speed);
  }
  void end(const End<double>& end) {
    for (const double x : {end.time, end.position, end.velocity}) note(x);
    told.push_back(static_cast<std::uint64_t>(end.evaluations));
  }
};

/// And all else that it tells but the stretches.
struct EventBits : ImpactBits {
  static constexpr bool hears_impacts_alone = false;
  static bool hears_stretches() { return false; }

  void peak(double time, double position) {
    note(time);
    note(position);
  }
  void turn(double time, double position, Wall ahead) {
    note(ahead == Wall::upper ? 1 : -1);
    note(time);
    note(position);
  }
  void hops(double time, Wall /*wall*/) { note(time); }
};

/// And those.
struct Bits : EventBits {
  static bool hears_stretches() { return true; }

  void stretch(double time, const Flight<double>& path, double duration) {
    for (const double x : {time, path.position, path.velocity, path.steady, duration}) note(x);
    for (int i = 0; i < path.harmonics; ++i) {
      note(path.acting(i).cosine);
      note(path.acting(i).sine);
    }
  }
};

/// The same of every scene, by itself and in lanes.
template <class SomeBits>
void expect_same_bits(const std::vector<Scene>& scenes) {
  std::vector<SomeBits> observers(scenes.size());
  const auto outcomes = run_in_lanes(
      scenes.size(), [&](std::size_t k) { return ImpactModel<double>(scenes[k]); },
      [&](std::size_t k) -> SomeBits& { return observers[k]; });
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    SomeBits alone;
    alone.end(ImpactModel<double>(scenes[k]).run(alone));
    ASSERT_FALSE(outcomes[k].failure);
    observers[k].end(outcomes[k].end);
    const auto& told = observers[k].told;
    ASSERT_EQ(told.size(), alone.told.size()) << "scene " << k;
    for (std::size_t i = 0; i < told.size(); ++i) {
      ASSERT_EQ(told[i], alone.told[i])
          << "scene " << k << ", number " << i << ": " << std::bit_cast<double>(told[i]);
    }
  }
}

/// Each at some neighbouring speeds, as in a scan.
std::vector<Scene> at_several_speeds(const Scene& scene, int speeds) {
  std::vector<Scene> scenes;
  for (int k = 0; k < speeds; ++k) {
    scenes.push_back(at_speed(scene, scene.omega * (1 + 1e-3 * k)));
  }
  return scenes;
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationAtManySpeeds) {
  RandomScenes random(41);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random.next();
    SCOPED_TRACE(i);
    expect_same_bits<Bits>(at_several_speeds(scene, 1 + i % 11));
  }
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationForOtherScenes) {
  RandomScenes random(42);
  for (const std::size_t size : {0U, 1U, 3U, 4U, 5U, 1000U}) {
    std::vector<Scene> scenes(size);
    for (Scene& scene : scenes) scene = random.next();
    expect_same_bits<Bits>(scenes);
    expect_same_bits<EventBits>(scenes);
    expect_same_bits<ImpactBits>(scenes);
  }
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationForHostileScenes) {
  std::vector<Scene> scenes;
  for (int i = 0; i < 1500; ++i) {
    const Scene scene = hostile_scene(7, i).scene;
    if (scene.fidelity == Fidelity::impact && scene.profile.empty()) scenes.push_back(scene);
  }
  ASSERT_GT(scenes.size(), 1000U);
  expect_same_bits<Bits>(scenes);
  expect_same_bits<EventBits>(scenes);
  expect_same_bits<ImpactBits>(scenes);
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationWhereTheForcesTurnFast) {
  RandomScenes random(43);
  std::vector<Scene> scenes;
  for (int i = 0; i < 300; ++i) {
    Scene scene = random.next();
    scene.disturbance_frequency = random.log_within(40, 4000);
    scene.disturbance = 0.3;
    scene.start_velocity = random.within(-2, 2);
    scenes.push_back(scene);
  }
  expect_same_bits<Bits>(scenes);
}

/// Throws at its third impact, if it is told to.
struct Impatient : Observer {
  static constexpr bool hears_impacts_alone = true;

  bool throws = false;
  int impacts = 0;

  void impact(double /*time*/, Wall /*wall*/, double /*speed*/) {
    if (++impacts == 3 && throws) throw std::domain_error("enough");
  }
};

TEST(ImpactLanes, EndsOnlyTheSimulationWhoseObserverThrows) {
  Scene scene;  // an elastic ball that nothing slows
  scene.start_velocity = 1;
  scene.window = Seconds{10};
  std::vector<Impatient> observers(6);
  observers[1].throws = true;
  const auto outcomes = run_in_lanes(
      observers.size(), [&](std::size_t) { return ImpactModel<double>(scene); },
      [&](std::size_t k) -> Impatient& { return observers[k]; });
  for (std::size_t k = 0; k < observers.size(); ++k) {
    EXPECT_EQ(observers[k].impacts, k == 1 ? 3 : 10) << k;
    EXPECT_EQ(outcomes[k].failure != nullptr, k == 1) << k;
  }
  EXPECT_THROW(std::rethrow_exception(outcomes[1].failure), std::domain_error);
}

}  // namespace
}  // namespace ricochet::carrier_track
