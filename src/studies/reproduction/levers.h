#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"

/// What moves the fastest quiet speed of the long run: the constants of the machine, and what
/// counts as a collision.
namespace ricochet::studies::reproduction {

/// The fastest quiet speed at one value of a constant.
struct CurvePoint {
  double value;                 ///< in SI units
  std::optional<double> speed;  ///< [rad/s]; nothing if every speed tried is quiet, or none is
};

/// The fastest quiet speed of a machine over one of its constants.
struct ThresholdCurve {
  carrier_track::Case machine;     ///< without an id where its restitution is what differs
  std::vector<CurvePoint> points;  ///< by rising value
};

/// Curves over restitutions from 0.05 to 0.95 for the frictions and disturbances of the cases, up
/// to the speed `highest` [rad/s]. A threshold takes a hundred times as long under a disturbance,
/// so such curves have fewer points, and there are none if the curves are `coarse`. Parallel.
std::vector<ThresholdCurve> restitution_curves(const std::vector<carrier_track::Case>& cases,
                                               const carrier_track::Scene& interpretation,
                                               bool coarse, double highest);

/// Curves of the cases without disturbance over another constant, by its key as sensitivities()
/// has it: "counting_limit" or "clearance". `values` in SI units, rising. Parallel.
std::vector<ThresholdCurve> curves_over(const std::string& key, const std::vector<double>& values,
                                        const std::vector<carrier_track::Case>& cases,
                                        const carrier_track::Scene& interpretation, double highest);

/// How far a constant moves the fastest quiet speed from one end to the other.
struct EndEffect {
  double from, to;     ///< of the constant
  double least, most;  ///< speed at `to` over that at `from`, over the pairs
  std::size_t pairs;
};

/// A machine's fastest quiet speed [rad/s].
struct QuietCase {
  carrier_track::Case the_case;
  std::optional<double> speed;
};

/// The effect of restitution, friction or disturbance, from pairs of cases that differ in it alone:
/// in its smallest and its largest value. Nothing if there is no such pair.
std::optional<EndEffect> effect_of(double carrier_track::Case::*constant,
                                   const std::vector<QuietCase>& cases);

/// The effect of what the curves are over, between two of its values.
std::optional<EndEffect> effect_of(const std::vector<ThresholdCurve>& curves, double from,
                                   double to);

/// "divides it by 3.4 to 4.5", "lowers it by 0.1 to 12 %".
std::string told(const EndEffect& effect);

/// The change of a case's fastest quiet speed per change of each constant, the largest first.
struct CaseExponents {
  std::string id;
  std::vector<carrier_track::Sensitivity> exponents;
};

/// What the report has of them.
struct Levers {
  std::vector<ThresholdCurve> over_restitution, over_counting_limit, over_clearance;
  std::vector<CaseExponents> exponents;  ///< of the cases without disturbance
};

/// See restitution_curves(). Parallel.
Levers levers_of(const std::vector<QuietCase>& cases, const carrier_track::Scene& interpretation,
                 bool coarse, double highest);

}  // namespace ricochet::studies::reproduction
