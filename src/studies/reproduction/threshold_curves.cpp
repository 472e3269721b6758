#include "src/studies/reproduction/threshold_curves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>
#include <utility>

#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;

// Between which the effect of restitution is told: those of the paper's cases.
constexpr double low = 0.1, high = 0.9;

/// Restitutions in thousandths, so that one of a case is met exactly: closer where curves are
/// steep.
std::vector<int> thousandths_of(bool disturbed, bool coarse) {
  if (disturbed) return {50, 75, 100, 150, 200, 300, 400, 500, 600, 700, 800, 900, 950};
  std::vector<int> all;
  for (int thousandths = 50; thousandths <= 950; thousandths += coarse ? 50 : 25) {
    all.push_back(thousandths);
  }
  return all;
}

std::optional<double> threshold_of(const Scene& scene, double highest) {
  if (!has_regimes(scene)) return std::nullopt;
  const auto speed = quiet_up_to(scene, quiet_per_turn, {slowest_speed, highest});
  return speed && *speed < highest ? speed : std::nullopt;
}

std::optional<double> speed_at(const ThresholdCurve& curve, double restitution) {
  for (const CurvePoint& point : curve.points) {
    if (point.restitution == restitution) return point.speed;
  }
  return std::nullopt;
}

/// The smallest and the largest of some numbers.
struct Extremes {
  std::optional<double> least, most;

  void take(double value) {
    least = std::min(least.value_or(value), value);
    most = std::max(most.value_or(value), value);
  }
};

/// How many times as fast the threshold is at low restitution as at high.
Extremes gains_of(const std::vector<ThresholdCurve>& curves) {
  Extremes gains;
  for (const ThresholdCurve& curve : curves) {
    const auto fast = speed_at(curve, low), slow = speed_at(curve, high);
    if (fast && slow) gains.take(*fast / *slow);
  }
  return gains;
}

/// [N]
double largest_disturbance(const std::vector<ThresholdCurve>& curves) {
  return std::ranges::max_element(curves, {}, &ThresholdCurve::disturbance)->disturbance;
}

/// The shares by which the largest disturbance lowers the threshold.
Extremes losses_of(const std::vector<ThresholdCurve>& curves) {
  const double most = largest_disturbance(curves);
  Extremes losses;
  for (const ThresholdCurve& still : curves) {
    for (const ThresholdCurve& shaken : curves) {
      const bool pair = still.friction == shaken.friction && still.disturbance == 0 &&
                        shaken.disturbance == most && most > 0;
      if (!pair) continue;
      for (const CurvePoint& point : shaken.points) {
        const auto from = speed_at(still, point.restitution);
        if (from && point.speed) losses.take(1 - *point.speed / *from);
      }
    }
  }
  return losses;
}

}  // namespace

std::vector<ThresholdCurve> threshold_curves(const std::vector<Case>& cases,
                                             const Scene& interpretation, bool coarse,
                                             double highest) {
  std::set<double> frictions, disturbances;
  for (const Case& c : cases) {
    frictions.insert(c.friction);
    disturbances.insert(coarse ? 0 : c.disturbance);
  }
  std::vector<ThresholdCurve> curves;
  std::vector<std::pair<std::size_t, std::size_t>> places;  // of all points
  for (const double friction : frictions) {
    for (const double disturbance : disturbances) {
      ThresholdCurve curve{friction, disturbance, {}};
      for (const int thousandths : thousandths_of(disturbance != 0, coarse)) {
        places.emplace_back(curves.size(), curve.points.size());
        curve.points.push_back({thousandths / 1000.0, {}});
      }
      curves.push_back(std::move(curve));
    }
  }
  Progress progress("thresholds over restitution", static_cast<double>(places.size()));
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    ThresholdCurve& curve = curves[places[i].first];
    CurvePoint& point = curve.points[places[i].second];
    Scene scene = interpretation;
    scene.restitution_lower = scene.restitution_upper = point.restitution;
    scene.friction = curve.friction;
    scene.disturbance = curve.disturbance;
    point.speed = threshold_of(scene, highest);
    progress.advance(1);
  });
  return curves;
}

report::Json threshold_curve_data(const std::vector<ThresholdCurve>& curves) {
  if (curves.empty()) return {};
  const Extremes gains = gains_of(curves), losses = losses_of(curves);
  return {{"curves", curves},
          {"low", low},
          {"high", high},
          {"least_gain", report::as_json(gains.least)},
          {"most_gain", report::as_json(gains.most)},
          {"most_loss", report::as_json(losses.most)},
          {"largest_disturbance", largest_disturbance(curves)}};
}

}  // namespace ricochet::studies::reproduction
