#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::studies::advice {

/// A constant of a machine that its maker may choose, and how far from its own value it is tried.
struct Knob {
  std::string name;  ///< "clearance"
  std::string unit;  ///< "mm"; empty for a ratio
  double least, own, most;
  std::vector<double> shares;  ///< at which it is tried together with the others, see value()
  /// The machine with another value, which is within least..most.
  carrier_track::Scene (*turned)(const carrier_track::Scene& scene, double value);

  /// At -1 the least value, at 0 the machine's own, at 1 the most, even in between.
  double value(double share) const;

  /// The values at its shares without those that repeat: one end may be the own value.
  std::vector<double> levels() const;
};

/// Restitution from half its own to half way to 1, friction from 0 to twice its own (to 0.2 where
/// it is 0), clearance from half to twice its own, and disturbance from 0 to twice its own, or,
/// where it is 0, to the larger of the friction force and the pull. Of walls that differ the lower
/// one's restitution is the value, and the upper one's goes with it. A clearance that is infinite,
/// and a disturbance without a force to compare it with, are left out.
std::vector<Knob> knobs_of(const carrier_track::Scene& scene);

}  // namespace ricochet::studies::advice
