#pragma once

#include <cstdint>
#include <random>

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

}  // namespace ricochet::carrier_track::inline oracle
