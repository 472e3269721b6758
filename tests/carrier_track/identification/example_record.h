#pragma once

#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"

namespace ricochet::carrier_track {

/// A carrier that is thrown from 2 rad/s on and rests on a wall each half turn.
inline Scene knocking_machine() {
  Scene scene;
  scene.mass = 1.8;
  scene.wall_upper = 0.7e-3;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.friction = 0.2;
  scene.normal_force = 11.8;
  scene.contact_friction = true;
  scene.pull = 0.01;
  scene.centrifugal_mass_radius = 0.58;
  scene.counting_limit = 6e-3;
  scene.start_position = 0;
  scene.phase = 1;
  return scene;
}

/// Synthetic knocks of that machine, from 3 to 6 rad/s in 15 s.
inline KnockRecord example_record(const SensorModel& sensor = {}, std::uint64_t seed = 1) {
  Random random(seed);
  return synthetic_knocks(knocking_machine(), {{0, 3}, {15, 6}}, sensor, random);
}

/// A point near the truth of that record.
inline Vector example_point(const KnockRecord& record) {
  KnockUnknowns at = guess_of(knocking_machine());
  at.spurious_rate = 0.05 * static_cast<double>(record.knocks.size()) / record.duration();
  at.recorded_share = 0.95;
  return point_of(at);
}

}  // namespace ricochet::carrier_track
