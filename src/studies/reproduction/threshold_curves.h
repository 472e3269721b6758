#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/scene.h"
#include "src/report/json.h"

namespace ricochet::studies::reproduction {

/// The fastest quiet speed at one restitution.
struct CurvePoint {
  double restitution;
  std::optional<double> speed;  ///< [rad/s]; nothing if every speed tried is quiet, or none is
};
RICOCHET_FIELDS(CurvePoint, restitution, speed);

/// The fastest quiet speed in the long run over restitution, of machines alike in all else.
struct ThresholdCurve {
  double friction;
  double disturbance;              ///< [N]
  std::vector<CurvePoint> points;  ///< by rising restitution
};
RICOCHET_FIELDS(ThresholdCurve, friction, disturbance, points);

/// The curves of the frictions and disturbances of the cases, friction first, over restitutions
/// from 0.05 to 0.95, up to the speed `highest` [rad/s]. A threshold takes a hundred times as long
/// under a disturbance, so such curves have fewer points, and there are none if the curves are
/// `coarse`. Parallel.
std::vector<ThresholdCurve> threshold_curves(const std::vector<carrier_track::Case>& cases,
                                             const carrier_track::Scene& interpretation,
                                             bool coarse, double highest);

/// The curves, and what they say: by which factors the lowest restitution of the paper's cases has
/// a faster threshold than the highest, and by which shares the largest disturbance lowers
/// thresholds. Null without curves.
report::Json threshold_curve_data(const std::vector<ThresholdCurve>& curves);

}  // namespace ricochet::studies::reproduction
