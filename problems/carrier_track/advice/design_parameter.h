#pragma once

#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::studies::advice {

/// A constant of a machine that its maker may choose, and its range around the machine's own value.
struct DesignParameter {
  std::string name;  ///< "clearance"
  std::string unit;  ///< "mm"; empty for a ratio
  double least, own, most;
  std::vector<double> shares;  ///< tried together with the others, see value()
  /// The machine with another value in least..most.
  carrier_track::Scene (*turned)(const carrier_track::Scene& scene, double value);

  /// The least value at -1, the machine's own at 0, the most at 1, linear in between.
  double value(double share) const;

  /// The values at its shares without repetitions: one end may be the own value.
  std::vector<double> levels() const;
};

/// Restitution from half its own to half way to 1; friction from 0 to twice its own (to 0.2 if it
/// is 0); clearance from half to twice its own; and disturbance from 0 to twice its own or, if it
/// is 0, to the larger of the friction force and the pull. If the walls differ, the value is the
/// lower one's restitution, and the upper one's changes with it. An infinite clearance is left out,
/// and so is a disturbance without a force to compare it with.
std::vector<DesignParameter> design_parameters_of(const carrier_track::Scene& scene);

}  // namespace ricochet::studies::advice
