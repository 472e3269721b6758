#pragma once

#include <cstdint>
#include <string_view>

#include "ricochet/vector.h"

/// Random numbers without a state: a draw depends on a key only, and a key on what it was made
/// from, so that each call or point has its own draws. Uses the mixing function of SplitMix64
/// (Steele, Lea and Flood, OOPSLA 2014, doi 10.1145/2660193.2660195; constants of Vigna's
/// splitmix64.c), where a change of any bit of the key changes about half of the bits drawn.
namespace ricochet {

/// A distinct key for every number, derived from a key.
std::uint64_t key_of(std::uint64_t key, std::uint64_t number);

/// The same for a name.
std::uint64_t key_of(std::uint64_t key, std::string_view name);

/// The same for a point, from all bits of all coordinates in their order; 0 and -0 are equal.
std::uint64_t key_of(std::uint64_t key, const Vector& point);

/// The draws of a key, one after the other: the sequence of SplitMix64.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : state_(key) {}

  std::uint64_t bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Of mean 0 and standard deviation 1, from two uniform draws (Box and Muller, Annals of
  /// Mathematical Statistics 29 (1958) 610, doi 10.1214/aoms/1177706645).
  double normal();

  /// Standard Cauchy: half of the draws lie outside [-1, 1], and there is no mean.
  double cauchy();

 private:
  std::uint64_t state_;
};

}  // namespace ricochet
