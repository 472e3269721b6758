#pragma once

#include <cstdint>

#include "problems/carrier_track/check/reference_integrators/wall_force.h"

// NOTE: plain C++17, like forces.h.
namespace ricochet::carrier_track::inline reference_integrators {

/// A scene as one smooth, possibly stiff, equation of motion: what a penalty method integrates.
struct PenaltySystem {
  Forces forces;  ///< without friction
  WallForce wall;
  double window;  ///< [s]
  double length;  ///< [m]; absolute tolerances are the relative one times this (and [m/s] alike)

  double acceleration(double time, const State& state) const {
    return forces.applied(time) + wall(state);
  }
};

/// An integrator that advances a PenaltySystem from its start, step by step.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// Takes one accepted step, which advances `time` [s] and `state`. They must be the result of the
  /// last step, or the start. The last step ends at the window's end or beyond. Throws
  /// std::runtime_error if the method fails.
  virtual void step(double& time, State& state) = 0;

  /// Evaluations of the acceleration so far.
  virtual std::int64_t evaluations() const = 0;
};

}  // namespace ricochet::carrier_track::inline reference_integrators
