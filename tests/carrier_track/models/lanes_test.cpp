#include "problems/carrier_track/motion/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/lane_flight.h"

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

bool same(const Lanes::Row& a, const Lanes::Row& b) {
  return std::bit_cast<std::array<char, sizeof a>>(a) ==
         std::bit_cast<std::array<char, sizeof b>>(b);
}

void expect_same(const Lanes& a, const Lanes& b) {
  EXPECT_TRUE(same(a.event, b.event) && same(a.time, b.time) && same(a.elapsed, b.elapsed) &&
              same(a.offset, b.offset) && same(a.velocity, b.velocity) &&
              same(a.direction, b.direction) && same(a.speed, b.speed) &&
              same(a.cosine[0], b.cosine[0]) && same(a.sine[1], b.sine[1]) &&
              same(a.evaluations, b.evaluations));
}

/// With every kind of instructions that this processor has. Returns how many bodies had an event.
int expect_same_by_all(const Lanes& lanes) {
  Lanes plain = lanes;
  fly_plain(plain);
  std::vector<void (*)(Lanes&)> others = {fly};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) others.push_back(fly_avx2);
#endif
  for (const auto other : others) {
    Lanes wide = lanes;
    other(wide);
    expect_same(wide, plain);
  }
  return static_cast<int>(
      std::ranges::count_if(plain.event, [](double event) { return event != Lanes::none; }));
}

TEST(Lanes, FlyToTheSameBitsWithAllInstructions) {
  RandomScenes random(11);
  int events = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    events += expect_same_by_all(random_lanes(random));
  }
  EXPECT_GT(events, 8 * 4500);
}

TEST(Lanes, RestToTheSameBitsWithAllInstructions) {
  RandomScenes random(13);
  int released = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    Lanes lanes = random_lanes(random);
    for (std::size_t k = 0; k < Lanes::size; ++k) {
      lanes.velocity[k] = lanes.direction[k] = 0;
      lanes.friction[k] = std::abs(lanes.steady[k]) + random.within(0, 6);
      lanes.wall[k] = random.below(3) - 1;
    }
    EXPECT_EQ(expect_same_by_all(lanes), 8);
    fly(lanes);
    released += static_cast<int>(
        std::ranges::count_if(lanes.direction, [](double direction) { return direction != 0; }));
  }
  EXPECT_GT(released, 5000);
}

TEST(Lanes, LeavesAFewThatRestToTheirCaller) {
  RandomScenes random(12);
  Lanes lanes = random_lanes(random);
  lanes.direction[2] = 0;
  const Lanes before = lanes;
  fly(lanes);
  EXPECT_EQ(lanes.event[2], Lanes::none);
  EXPECT_EQ(lanes.time[2], before.time[2]);
  EXPECT_EQ(lanes.offset[2], before.offset[2]);
}

}  // namespace
}  // namespace ricochet::carrier_track
