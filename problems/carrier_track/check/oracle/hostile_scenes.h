#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// What makes a scene hard to get right. 10^-k is its closeness.
enum class Hostility {
  none,            ///< a random scene as it is
  graze,           ///< the upper wall lies 10^-k, of the gap, from a summit of the free path
  counting_limit,  ///< `slowest` lies 10^-k, of itself, from the speed of an impact
  restitution,     ///< 0, 1 or 1 - 10^-k at either wall
  friction_limit,  ///< friction is 10^-k, of itself, from the largest force
  start_on_wall,   ///< starts at rest on a wall
  cancelling,      ///< two waves nearly of one frequency, nearly opposite
  slow_plate,      ///< a plate that hardly turns
  fast_plate,      ///< forces that change many times in a flight
  open_above,      ///< no upper wall
  no_pull,         ///< no steady force
  slow_limit,      ///< `slowest` of 1e-15 to 1e-9 m/s, so that hops of all sizes count
  maxima,          ///< maxima count, in hops that end on a wall too
};

const std::vector<Hostility>& all_hostilities();
std::string_view name_of(Hostility hostility);

struct HostileScene {
  Hostility hostility;
  /// Signed distance to the exact limit, relative as the hostility says, before it is rounded to a
  /// double; 0 where there is none. Above 0 a graze misses, an impact is too slow to count, and
  /// friction holds.
  double closeness = 0;
  Scene scene;
};

/// Scene `index` >= 0 of `seed` of a hostility, each computable alone. A hostility that needs a
/// summit or an impact draws until there is one.
HostileScene hostile_scene(Hostility hostility, int seed, int index);

/// The same where the hostilities take turns.
HostileScene hostile_scene(int seed, int index);

}  // namespace ricochet::carrier_track::inline oracle
