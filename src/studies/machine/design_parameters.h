#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/report/json.h"

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

// How a machine's fastest quiet speed depends on its constants.

/// Speeds in geometric progression.
struct CoarseScan {
  double lowest, highest;  ///< [rad/s], > 0
  double ratio = 1.01;
};

/// The quiet speeds of a machine under a limit, from a coarse scan.
struct QuietRange {
  /// [rad/s], up to which every scanned speed is quiet, located to a sixteenth of the scan's step;
  /// the highest speed if all are quiet, empty if the lowest is loud.
  std::optional<double> quiet;
  std::optional<double> divide;  ///< [rad/s], the speed that best separates quiet from loud; of a
                                 ///< limit of the window
  bool mixed = false;            ///< in the window no speed separates them
  bool to_the_end = false;       ///< no scanned speed is loud
  bool simulated = true;         ///< false: more impacts or steps than a simulation may have
};

/// Whether an undisturbed machine has speeds at which its motion does not repeat: each machine like
/// it would take seconds.
bool is_irregular(const carrier_track::Scene& scene, const carrier_track::QuietSpeed& answer);

/// From an eighth of the answer's own speed to the fastest of its scan, with a ratio of 1.01, or of
/// 1.04 for compliant walls, which take some thirty times as long; empty if the answer has no
/// limit, or if an undisturbed machine has irregular regimes.
std::optional<CoarseScan> coarse_scan(const carrier_track::Scene& scene,
                                      const carrier_track::QuietSpeed& answer);

QuietRange quiet_range(const carrier_track::Scene& scene, const carrier_track::Limit& limit,
                       const CoarseScan& scan);

/// The quiet ranges of a machine for every combination of its design parameters' levels, and along
/// each design parameter with the others at the machine's own values.
struct DesignParameterGrid {
  static constexpr std::size_t points_of_a_line = 21;

  CoarseScan scan;
  bool long_run;  ///< whether the limit is about the long run
  std::vector<DesignParameter> design_parameters;
  std::vector<std::vector<double>> levels;     ///< of each design parameter
  std::vector<QuietRange> combinations;        ///< the last design parameter's level changes first
  std::vector<std::vector<QuietRange>> lines;  ///< of each design parameter, at shares -1 .. 1
  QuietRange own;
};

/// Empty where coarse_scan() is. Takes some 150,000 simulations, in parallel.
std::optional<DesignParameterGrid> design_parameter_grid(const carrier_track::Scene& scene,
                                                         const carrier_track::QuietSpeed& answer);

/// Data for the page: design parameters with their levels, an answer for each combination, lines,
/// and the gain from each design parameter alone, the largest first. Null without a grid.
report::Json json_of(const std::optional<DesignParameterGrid>& grid);

}  // namespace ricochet::studies::advice
