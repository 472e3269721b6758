#pragma once

#include <cstdint>
#include <random>

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// Valid scenes that between them use every term of equation (31), every kind of wall and start,
/// with some tens of impacts each. The same seed gives the same scenes everywhere: the draws use
/// only the generator's bits, whose sequence the standard fixes.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : random_(seed) {}

  Scene next();

  /// One with a second direction, whose forces are of the size of those of the first.
  Scene next_planar();

  /// Evenly in [a, b).
  double within(double a, double b);
  /// With evenly spread logarithm in [a, b), for 0 < a < b.
  double log_within(double a, double b);
  bool chance(double probability);
  /// Evenly in 0, 1, ..., limit - 1.
  int below(int limit);

 private:
  double restitution();
  double share_of_gap();

  std::mt19937_64 random_;
};

}  // namespace ricochet::carrier_track
