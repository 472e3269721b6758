#pragma once

#include <span>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

/// Turns of the driver plate under a disturbance, simulated side by side.
namespace ricochet::carrier_track::inline regimes {

/// What stands for the margin of an impact that is not there, or slower: some of these are not
/// simulated.
inline constexpr double lowest_margin = -2;

/// One turn of the driver plate under a disturbance.
struct DisturbedTurn {
  double phase;                 ///< [rad], of the disturbance at the start of the turn
  std::vector<Impact> impacts;  ///< by time, those of margins above lowest_margin
  std::vector<double> margins;  ///< ln(speed / counting limit) of these, the largest first
  double first;                 ///< margin of the first of them by time, or lowest_margin
  int collisions;
  double start_position, start_velocity;  ///< [m], [m/s]
  double end_position, end_velocity;

  /// That of the rank-th fastest impact, rank 1 the fastest; at least lowest_margin.
  double margin(int rank) const {
    const bool is_there = rank >= 1 && rank <= static_cast<int>(margins.size());
    return is_there ? margins[static_cast<std::size_t>(rank - 1)] : lowest_margin;
  }
};

/// The start of a turn: speed [rad/s], phase [rad] of the disturbance, and the carrier [m], [m/s].
struct TurnStart {
  double omega, phase;
  double position, velocity;
};

/// The turns from these starts; see turns_at_phases().
std::vector<DisturbedTurn> turns_from(const Scene& scene, std::span<const TurnStart> starts);

/// Lets the carriers move, from where they are, during the `turns` turns before those that start.
void pass(const Scene& scene, std::vector<TurnStart>& starts, int turns);

/// The turns that follow on `before` turns from the start of a valid scene of fidelity impact, for
/// these phases [rad] of its disturbance at their start. Side by side, and without the last of a
/// series of rebounds: impacts are exact where the carrier rests before it moves again.
std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before);

/// Lets the turns of the plate begin where its force passes zero from above: a carrier that rests
/// in every half turn then rests.
void begin_turns_at_rest(Scene& scene);

/// A turn, simulated to the last rebound.
struct ObservedTurn {
  int collisions;
  double fastest;        ///< [m/s], 0 without impacts
  double energy;         ///< [J], that the walls take
  double share_at_rest;  ///< of the time
};

/// The `turns` turns that follow on `before` turns from the start of a valid scene of fidelity
/// impact, for each of these phases [rad] of its disturbance there.
std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns);

}  // namespace ricochet::carrier_track::inline regimes
