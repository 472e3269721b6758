#pragma once

#include <cstdint>
#include <string_view>

#include "src/core/vector.h"

/// Random numbers without a state to keep: what is drawn depends on a key alone, and a key on what
/// it was made of, so that a call or a point has draws of its own. With the mixing function of
/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, doi 10.1145/2660193.2660195; constants of
/// Vigna's splitmix64.c), which turns every bit of the key into a change of half the bits drawn.
namespace ricochet {

/// A key of its own for every number, under a key.
std::uint64_t key_of(std::uint64_t key, std::uint64_t number);

/// For every name.
std::uint64_t key_of(std::uint64_t key, std::string_view name);

/// For every point, by all bits of all coordinates in their order; 0 and -0 are the same.
std::uint64_t key_of(std::uint64_t key, const Vector& point);

/// The draws of a key, one after the other: the sequence of SplitMix64.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : state_(key) {}

  std::uint64_t bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Of mean 0 and deviation 1, from two uniform ones (Box and Muller, Annals of Mathematical
  /// Statistics 29 (1958) 610, doi 10.1214/aoms/1177706645).
  double normal();

  /// Of the standard Cauchy distribution: half of them lie beyond -1 and 1, and it has no mean.
  double cauchy();

 private:
  std::uint64_t state_;
};

}  // namespace ricochet
