#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// The impacts of a turn over a small window of phases: a polynomial through the speeds of each, at
/// the Chebyshev nodes, whose turns are simulated side by side.
class PhaseWindow {
 public:
  static constexpr std::size_t nodes = 8;

  /// Around a centre, as far as `reach` [rad] to each side; for margins of that rank.
  PhaseWindow(const DisturbedMotion& motion, int rank, double centre, double reach);

  /// False if the impacts do not correspond at all phases.
  bool is_known() const { return known_; }

  /// What the polynomials leave out, relative to the speeds.
  double error() const { return error_; }

  struct Valley {
    double phase;  ///< [rad]
    double value;  ///< sign times margin
    bool inside;   ///< false at an end of the window
  };

  /// Where sign times the margin is least within the window.
  Valley least(double sign) const;

 private:
  using Polynomial = std::array<double, nodes>;  // coefficients of Chebyshev polynomials

  double speed_at(double place) const;
  void fit(const std::vector<DisturbedTurn>& turns);

  int rank_;
  double centre_, reach_;
  double counting_limit_;
  bool known_ = false;
  double error_ = 0;
  std::size_t faster_ = 0;  // impacts that are faster than the rank's in the whole window
  std::vector<Polynomial> speeds_;
  mutable std::vector<double> there_;  // speeds at one phase, kept for their memory
};

/// Turns of a settled motion that few phases have: with fewer or more collisions than any that the
/// motion knows, between phases whose turns differ much.
std::vector<DisturbedTurn> rare_turns(const DisturbedMotion& motion);

/// The collisions in a turn at one speed, as simulated from some phases of the disturbance: turns
/// that fewer phases have are missed.
struct SampledTurns {
  double omega;  ///< [rad/s]
  double mean_per_turn;
  int most_per_turn;
};

inline constexpr int sampled_phases = 24;
inline constexpr int sampled_turns_each = 20;  ///< after as many to settle

/// Simulates turns of a valid scene with regimes (has_regimes) at speeds [rad/s] with equal ratios,
/// from `from` to `to`, both included. If a TimeLimit is reached, or a simulation has too many
/// impacts, the slower speeds are missing.
std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to);

}  // namespace ricochet::carrier_track::inline regimes
