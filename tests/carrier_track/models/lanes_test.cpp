#include "problems/carrier_track/models/lanes.h"

#include <gtest/gtest.h>

#include <bit>

#include "problems/carrier_track/models/lane_flight.h"
#include "problems/carrier_track/oracle/random_scenes.h"

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

TEST(Lanes, FlyToTheSameBitsWithAllInstructions) {
  RandomScenes random(11);
  int events = 0;
  for (int i = 0; i < 5000; ++i) {
    Lanes chosen = random_lanes(random);
    Lanes plain = chosen;
    fly(chosen);
    fly_plain(plain);
    EXPECT_TRUE(same(chosen.event, plain.event) && same(chosen.time, plain.time) &&
                same(chosen.offset, plain.offset) && same(chosen.velocity, plain.velocity) &&
                same(chosen.direction, plain.direction) && same(chosen.speed, plain.speed) &&
                same(chosen.cosine[0], plain.cosine[0]) && same(chosen.sine[1], plain.sine[1]) &&
                same(chosen.evaluations, plain.evaluations))
        << i;
    for (const double event : plain.event) events += event != Lanes::none ? 1 : 0;
  }
  EXPECT_GT(events, 4 * 4500);
}

TEST(Lanes, LeavesARestingBodyAlone) {
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
