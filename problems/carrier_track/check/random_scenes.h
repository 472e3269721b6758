#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// Valid scenes that together use every term of equation (31) and every kind of wall and start,
/// with some tens of impacts each. The same seed gives the same scenes everywhere: the draws use
/// only the generator's bits, whose sequence the standard fixes.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : random_(seed), phases_(seed + 1) {}

  Scene next();

  /// A scene with a second direction, whose forces have the size of those of the first.
  Scene next_planar();

  /// Uniform in [a, b).
  double within(double a, double b);
  /// In [a, b) with a uniform logarithm, for 0 < a < b.
  double log_within(double a, double b);
  bool chance(double probability);
  /// Uniform in 0, 1, ..., limit - 1.
  int below(int limit);

 private:
  double restitution();
  double share_of_gap();
  double angle();

  std::mt19937_64 random_;
  std::mt19937_64
      phases_;  // separate, to allow a comparison of scenes that differ only in their phases
};

/// What makes a scene hard to simulate correctly. 10^-k is its closeness.
enum class Hostility {
  none,            ///< an unchanged random scene
  graze,           ///< the upper wall lies 10^-k, of the gap, from a summit of the free path
  counting_limit,  ///< counting limit at relative distance 10^-k from the speed of an impact
  restitution,     ///< 0, 1 or 1 - 10^-k at either wall
  friction_limit,  ///< friction at relative distance 10^-k from the largest force
  start_on_wall,   ///< starts at rest on a wall
  cancelling,      ///< two almost opposite waves of almost equal frequency
  slow_plate,      ///< a plate that hardly turns
  fast_plate,      ///< forces that change many times per flight
  open_above,      ///< no upper wall
  no_pull,         ///< no steady force
  slow_limit,      ///< counting limit of 1e-15 to 1e-9 m/s, so that chattering of all sizes counts
  maxima,          ///< maxima count, even in flights that end on a wall
};

const std::vector<Hostility>& all_hostilities();
std::string_view name_of(Hostility hostility);

struct HostileScene {
  Hostility hostility;
  /// Signed distance to the exact limit, relative as above, before rounding to a double; 0 if none.
  /// Above 0 the path misses the wall (graze), the impact is too slow to count, and friction holds.
  double closeness = 0;
  Scene scene;
};

/// Scene `index` >= 0 of `seed` for a hostility; each can be computed alone. A hostility that needs
/// a summit or an impact draws until there is one.
HostileScene hostile_scene(Hostility hostility, int seed, int index);

/// The same, with the hostilities in turn.
HostileScene hostile_scene(int seed, int index);

}  // namespace ricochet::carrier_track::inline oracle
