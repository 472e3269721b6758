#include "problems/carrier_track/motion/lanes.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/lane_flight.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Bodies in the middle of their motion.
Lanes random_lanes(RandomScenes& random) {
  Lanes lanes;
  lanes.harmonics = 1 + random.below(2);
  for (std::size_t k = 0; k < Lanes::size; ++k) {
    lanes.steady[k] = random.within(-3, 3);
    lanes.friction[k] = random.within(0, 1);
    lanes.wall_upper[k] = random.log_within(1e-4, 1e-2);
    lanes.restitution_lower[k] = random.within(0, 1);
    lanes.restitution_upper[k] = random.within(0, 1);
    lanes.duration[k] = 1;
    lanes.offset[k] = lanes.wall_upper[k] * random.within(0, 1);
    lanes.velocity[k] = random.within(-0.1, 0.1);
    lanes.direction[k] = lanes.velocity[k] > 0 ? 1 : -1;
    for (std::size_t h = 0; h < 2; ++h) {
      lanes.frequency[h][k] = random.log_within(0.3, 300);
      lanes.cosine[h][k] = random.within(-3, 3);
      lanes.sine[h][k] = random.within(-3, 3);
    }
  }
  return lanes;
}

/// The bits of all that a flight changes.
auto results_of(const Lanes& lanes) {
  const Lanes::Row rows[] = {lanes.event,     lanes.time,      lanes.elapsed, lanes.offset,
                             lanes.velocity,  lanes.direction, lanes.speed,   lanes.cosine[0],
                             lanes.cosine[1], lanes.sine[0],   lanes.sine[1], lanes.evaluations};
  return std::bit_cast<std::array<char, sizeof rows>>(rows);
}

/// With every kind of instructions that this processor has. Returns how many bodies had an event.
auto expect_same_by_all(const Lanes& lanes) {
  Lanes plain = lanes;
  fly_plain(plain);
  std::vector<void (*)(Lanes&)> others = {fly};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) others.push_back(fly_avx2);
#endif
  for (const auto other : others) {
    Lanes wide = lanes;
    other(wide);
    EXPECT_EQ(results_of(wide), results_of(plain));
  }
  return std::ranges::count_if(plain.event, [](double event) { return event != Lanes::none; });
}

TEST(Lanes, FlyAndRestToTheSameBitsWithAllInstructions) {
  std::ptrdiff_t events = 0, released = 0;
  for_random(11, 5000, [&](RandomScenes& random) {
    Lanes lanes = random_lanes(random);
    events += expect_same_by_all(lanes);
    for (std::size_t k = 0; k < Lanes::size; ++k) {  // at rest
      lanes.velocity[k] = lanes.direction[k] = 0;
      lanes.friction[k] = std::abs(lanes.steady[k]) + random.within(0, 6);
      lanes.wall[k] = random.below(3) - 1;
    }
    EXPECT_EQ(expect_same_by_all(lanes), 8);
    fly(lanes);
    released += std::ranges::count_if(lanes.direction, [](double way) { return way != 0; });
  });
  EXPECT_GT(events, 8 * 4500);
  EXPECT_GT(released, 5000);
}

/// What a simulation tells and its end, number by number: impacts alone, all but the stretches, or
/// all.
enum class Heard { impacts, events, all };
template <Heard heard>
struct Bits : Observer {
  static constexpr bool hears_impacts_alone = heard == Heard::impacts;
  static bool hears_stretches() { return heard == Heard::all; }

  std::vector<std::uint64_t> told;

  template <class... Numbers>
  void note(Heard by, Numbers... x) {
    if (heard >= by) (told.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(x))), ...);
  }
  void impact(double time, Wall wall, double speed) {
    note(Heard::impacts, wall == Wall::upper, time, speed);
  }
  void peak(double time, double position) { note(Heard::events, time, position); }
  void turn(double time, double position, Wall ahead) {
    note(Heard::events, ahead == Wall::upper, time, position);
  }
  void hops(double time, Wall /*wall*/) { note(Heard::events, time); }
  void stretch(double time, const Flight<double>& path, double duration) {
    note(Heard::all, time, path.position, path.velocity, path.steady, duration);
    for (int i = 0; i < path.harmonics; ++i) {
      note(Heard::all, path.acting(i).cosine, path.acting(i).sine);
    }
  }
  void end(const End<double>& end) {
    note(Heard::impacts, end.time, end.position, end.velocity, end.evaluations);
  }
};

/// The same of every scene, by itself and in lanes.
template <Heard heard>
void expect_same_bits(const std::vector<Scene>& scenes) {
  std::vector<Bits<heard>> observers(scenes.size());
  const auto outcomes = run_in_lanes(
      scenes.size(), [&](std::size_t k) { return ImpactModel<double>(scenes[k]); },
      [&](std::size_t k) -> Bits<heard>& { return observers[k]; });
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    Bits<heard> alone;
    alone.end(ImpactModel<double>(scenes[k]).run(alone));
    ASSERT_FALSE(outcomes[k].failure);
    observers[k].end(outcomes[k].end);
    ASSERT_EQ(observers[k].told, alone.told) << "scene " << k;
  }
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationAtManySpeeds) {
  for_random(41, 300, [](RandomScenes& random) {
    const Scene scene = random.next();
    std::vector<Scene> scenes(static_cast<std::size_t>(1 + random.below(11)), scene);
    for (std::size_t k = 0; k < scenes.size(); ++k) {  // neighbouring ones, as in a scan
      scenes[k] = at_speed(scene, scene.omega * (1 + 1e-3 * static_cast<double>(k)));
    }
    expect_same_bits<Heard::all>(scenes);
  });
}

TEST(ImpactLanes, GivesTheBitsOfASingleSimulationForOtherScenes) {
  RandomScenes random(42);
  std::vector<std::vector<Scene>> lists;
  for (const std::size_t size : {0U, 1U, 3U, 4U, 5U, 1000U}) {
    for (Scene& scene : lists.emplace_back(size)) scene = random.next();
  }
  for (Scene& scene : lists.emplace_back(300)) {  // where the forces turn fast
    scene = with(random.next(), set::disturbance(0.3),
                 set::disturbance_frequency(random.log_within(40, 4000)),
                 set::start_velocity(random.within(-2, 2)));
  }
  lists.emplace_back();
  for (int i = 0; i < 1500; ++i) {
    const Scene scene = hostile_scene(7, i).scene;
    if (scene.fidelity == Fidelity::impact && scene.profile.empty()) lists.back().push_back(scene);
  }
  ASSERT_GT(lists.back().size(), 1000U);
  for (const auto& scenes : lists) {
    expect_same_bits<Heard::all>(scenes);
    expect_same_bits<Heard::events>(scenes);
    expect_same_bits<Heard::impacts>(scenes);
  }
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
  // An elastic ball that nothing slows.
  const Scene scene = with(Scene{}, set::start_velocity(1), set::seconds(10));
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
