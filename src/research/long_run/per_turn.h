#pragma once

#include "ricochet/scene.h"

/// Collisions a turn in the long run.
namespace ricochet::studies::long_run {

/// The mean collisions a turn of the motion that a valid scene settles on at its constant speed,
/// over all phases of a disturbance: exact where the motion repeats and, with a disturbance, but
/// for the 16 phases of the mean.
double collisions_per_turn(const carrier_track::Scene& scene);

/// The same for searches, in some 20 microseconds: the mean over a few turns that begin at rest on
/// a wall. Exact where every turn has a rest; more than `most` collisions a turn are taken as one
/// more.
double brief_collisions_per_turn(const carrier_track::Scene& scene, int most);

}  // namespace ricochet::studies::long_run
