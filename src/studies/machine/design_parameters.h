#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/report/results.h"

/// How a machine's fastest quiet speed depends on what its maker may choose.
namespace ricochet::studies::advice {

/// A constant of a machine that its maker may choose, and its range around the machine's own value.
struct DesignParameter {
  std::string name;  ///< "clearance"
  std::string unit;  ///< "mm"; empty for a ratio
  double least, own, most;
  /// The machine with another value in least..most.
  carrier_track::Scene (*turned)(carrier_track::Scene scene, double value);

  /// The least value at -1, the machine's own at 0, the most at 1, linear in between.
  double value(double share) const;
};

/// Restitution from half its own to half way to 1; friction from 0 to twice its own (to 0.2 if it
/// is 0); clearance from half to twice its own; and disturbance from 0 to twice its own or, if it
/// is 0, to the larger of the friction force and the pull. If the walls differ, the value is the
/// lower one's restitution, and the upper one's changes with it. An infinite clearance is left out,
/// and so is a disturbance without a force to compare it with.
std::vector<DesignParameter> design_parameters_of(const carrier_track::Scene& scene);

/// Speeds in geometric progression.
struct CoarseScan {
  double lowest, highest;  ///< [rad/s], > 0
  double ratio = 1.01;
};

/// Whether an undisturbed machine has speeds at which its motion does not repeat: each machine like
/// it would take seconds.
bool is_irregular(const carrier_track::Scene& scene, const carrier_track::QuietSpeed& answer);

/// From an eighth of the answer's own speed to the fastest of its scan, with a ratio of 1.01, 1.02
/// in the long run, and 1.04 for compliant walls, which take some thirty times as long; empty if
/// the answer has no limit, or if the machine is irregular.
std::optional<CoarseScan> coarse_scan(const carrier_track::Scene& scene,
                                      const carrier_track::QuietSpeed& answer);

/// The speed [rad/s] up to which every scanned speed is quiet, located to a sixteenth of the scan's
/// step, or in the long run of a machine without disturbance exactly; the highest speed if all are
/// quiet. Nothing if the lowest is loud, or where a simulation would have more impacts or steps
/// than it may have.
std::optional<double> quiet_by_scan(const carrier_track::Scene& scene,
                                    const carrier_track::Limit& limit, const CoarseScan& scan);

/// The machine along a design parameter, the others at the machine's own values.
struct DesignLine {
  static constexpr std::size_t points = 21;

  DesignParameter parameter;
  std::vector<double> values;                ///< at shares -1 .. 1
  std::vector<std::optional<double>> quiet;  ///< see quiet_by_scan()
};

/// A line for each design parameter; none without a scan. In parallel.
std::vector<DesignLine> design_lines(const carrier_track::Scene& scene,
                                     const carrier_track::QuietSpeed& answer);

/// Adds what the page says of them: the table "design-parameters", the largest gain first; a part
/// "design" with a chart for each; and the values "design", the largest gain in a sentence,
/// "design-own", the machine's own fastest quiet speed [rad/s] by the same scan, and
/// "design-method". Without lines the values are missing.
void add_design(const std::vector<DesignLine>& lines, const carrier_track::QuietSpeed& answer,
                const std::optional<CoarseScan>& scan, report::Results& results);

}  // namespace ricochet::studies::advice
