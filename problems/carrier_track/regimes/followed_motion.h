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

/// A margin of an impact as a function of the speed: ln(approach speed / counting limit).
struct Margin {
  double value;
  double slope;  ///< per unit of the logarithm of the speed
  /// Which impact of the period: the series of impacts on one wall that it belongs to, and its
  /// place there. Under a disturbance, which extreme.
  std::size_t series = 0, place = 0;
};

/// The margins of a motion.
struct Margins {
  std::vector<Margin> known;
  /// By which walls the impacts are, and how many are in a series that does not end in a rest: it
  /// changes where the carrier starts or ceases to touch a wall.
  std::vector<std::size_t> structure;
};

Signature signature_of(const SteadyMotion& motion);
Signature signature_of(const DisturbedMotion& motion);

/// Makes sure that the collisions of a motion are known.
inline void observe(SteadyMotion& /*motion*/) {}

/// The mean.
double collisions_per_turn(const SteadyMotion& motion);
double collisions_per_turn(const DisturbedMotion& motion);

/// The place among a period's impacts of the `rank`-th fastest, rank 1 the fastest; nothing if
/// there are fewer.
std::optional<std::size_t> place_of_rank(const SteadyMotion& motion, int rank);

/// ln(speed / counting limit) of the `rank`-th fastest impact of a period, rank 1 the fastest: it
/// counts if that is > 0. At least lowest_margin.
double rank_margin(const SteadyMotion& motion, int rank, Extreme extreme = Extreme::most);

/// The margins of all impacts that are not far slower than the counting limit; under a disturbance,
/// those of the slowest that counts and of the fastest that does not.
Margins margins_of(const SteadyMotion& motion);
Margins margins_of(const DisturbedMotion& motion);

/// Whether two motions of equal signature at speeds next to each other have the same collisions,
/// with speeds that differ by at most some 20 %.
bool is_near(const SteadyMotion& a, const SteadyMotion& b);
bool is_near(const DisturbedMotion& a, const DisturbedMotion& b);

LongRun long_run_of(const SteadyMotion& motion);
LongRun long_run_of(const DisturbedMotion& motion);

}  // namespace ricochet::carrier_track::inline regimes
