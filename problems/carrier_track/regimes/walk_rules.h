#pragma once

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/regimes/followed_motion.h"

/// What a walk from border to border does in another way for motions that repeat than for those
/// under a disturbance. Steps are in the logarithm of the speed.
namespace ricochet::carrier_track::inline regimes {

/// The largest modulus of the eigenvalues of a period.
inline double memory_of(const SteadyMotion& motion) {
  const double half = motion.trace / 2;
  const double square = half * half - motion.determinant;
  return square >= 0 ? std::abs(half) + std::sqrt(square) : std::sqrt(motion.determinant);
}
inline double memory_of(const DisturbedMotion& /*motion*/) {
  return 0;
}

/// Whether several motions may be possible at one speed: then the way to a border is looked at,
/// too.
inline bool may_have_others(const SteadyMotion& /*motion*/) {
  return true;
}
inline bool may_have_others(const DisturbedMotion& /*motion*/) {
  return false;
}

/// The longest step between motions with different impacts: one that appears may make others
/// slower, and two that were just about to count vanish between the ends of the step.
inline double unlike_step_of(const SteadyMotion& /*motion*/) {
  return 1e-5;
}
inline double unlike_step_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;
}

/// The longest step: an impact may come and go within a longer one.
inline double longest_of(const SteadyMotion& /*motion*/) {
  return 0.02;
}
inline double longest_of(const DisturbedMotion& /*motion*/) {
  return 0.03;
}

/// The longest first step after a border: what ends there under a disturbance may begin again.
inline double longest_first_of(const SteadyMotion& /*motion*/) {
  return 0.01;
}
inline double longest_first_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;
}

inline double shortest_of(const SteadyMotion& /*motion*/) {
  return 1e-7;
}
inline double shortest_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;  // margins have no exact slopes there
}

/// The long run beyond a border with this long run before it.
inline LongRun long_run_beyond(const LongRun& /*before*/, RegimeEnd /*kind*/,
                               const SteadyMotion& motion) {
  return long_run_of(motion);
}
inline LongRun long_run_beyond(const LongRun& before, RegimeEnd kind,
                               const DisturbedMotion& motion) {
  // Where one impact passes the limit at one phase, no mean changes.
  if (kind != RegimeEnd::counting_limit) return long_run_of(motion);
  LongRun beyond = before;
  beyond.orbit = motion.machine;
  return beyond;
}

/// Takes the collisions of a motion into a regime.
inline void widen(Regime& regime, double least, double most) {
  regime.least_per_turn = std::min(regime.least_per_turn, least);
  regime.most_per_turn = std::max(regime.most_per_turn, most);
}
inline void widen(Regime& regime, const SteadyMotion& motion) {
  widen(regime, motion.collisions_per_turn(), motion.collisions_per_turn());
}
inline void widen(Regime& regime, const DisturbedMotion& motion) {
  widen(regime, motion.least, motion.most);
}

/// Lets a motion watch what another at its speed watches.
inline void join(SteadyMotion& /*motion*/, const SteadyMotion& /*other*/) {}
inline void join(DisturbedMotion& motion, const DisturbedMotion& other) {
  for (const DisturbedTurn& turn : other.watched)
    watch(motion, phase_in(motion, other, turn.phase));
}

}  // namespace ricochet::carrier_track::inline regimes
