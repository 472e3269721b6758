#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/regimes.h"

/// What is watched of a motion while the speed changes, whether it repeats or is disturbed.
namespace ricochet::carrier_track::inline regimes {

/// What stays the same within a regime.
struct Signature {
  int turns;        ///< in a period
  int least, most;  ///< collisions in a period
  bool settled;
  bool rests;
  bool moves;

  bool operator==(const Signature&) const = default;

  /// Whether two motions are of one kind, though they may count differently.
  bool same_kind(const Signature& other) const {
    return turns == other.turns && settled == other.settled && rests == other.rests &&
           moves == other.moves;
  }
};

/// A margin of an impact as a function of the speed: see rank_margin.
struct Margin {
  double value;
  double slope;  ///< per unit of the logarithm of the speed
};

Signature signature_of(const SteadyMotion& motion);
Signature signature_of(const DisturbedMotion& motion);

/// The place among a period's impacts of the `rank`-th fastest, rank 1 the fastest; nothing if
/// there are fewer.
std::optional<std::size_t> place_of_rank(const SteadyMotion& motion, int rank);

/// ln(speed / counting limit) of the `rank`-th fastest impact of a period, rank 1 the fastest: it
/// counts if that is > 0. At least lowest_margin.
double rank_margin(const SteadyMotion& motion, int rank, Extreme extreme = Extreme::most);

/// The margins of the slowest impact that counts and of the fastest that does not, in a fixed
/// order; those that are far away may be left out.
std::vector<Margin> margins_of(const SteadyMotion& motion);
std::vector<Margin> margins_of(const DisturbedMotion& motion);

DisturbedMotion followed(const DisturbedMotion& motion, double omega);

LongRun long_run_of(const SteadyMotion& motion);
LongRun long_run_of(const DisturbedMotion& motion);

}  // namespace ricochet::carrier_track::inline regimes
