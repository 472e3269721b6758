#include "src/research/reproduction/threshold_curves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/regimes.h"
#include "ricochet/threshold.h"
#include "src/core/progress.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

// In thousandths, so that a restitution of a case is met exactly.
constexpr int least_restitution = 50, most_restitution = 950;
// Between which the effect of restitution is told: those of the paper's cases.
constexpr double low = 0.1, high = 0.9;

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
      for (std::size_t i = 0; pair && i < still.points.size(); ++i) {
        const auto &from = still.points[i].speed, &to = shaken.points[i].speed;
        if (from && to) losses.take(1 - *to / *from);
      }
    }
  }
  return losses;
}

}  // namespace

std::vector<ThresholdCurve> threshold_curves(const std::vector<Case>& cases,
                                             const Scene& interpretation, int steps,
                                             double highest) {
  std::set<double> frictions, disturbances;
  for (const Case& c : cases) {
    frictions.insert(c.friction);
    disturbances.insert(c.disturbance);
  }
  std::vector<ThresholdCurve> curves;
  for (const double friction : frictions) {
    for (const double disturbance : disturbances) {
      ThresholdCurve& curve = curves.emplace_back(ThresholdCurve{friction, disturbance, {}});
      for (int i = 0; i <= steps; ++i) {
        const int thousandths =
            least_restitution + (most_restitution - least_restitution) * i / steps;
        curve.points.push_back({thousandths / 1000.0, {}});
      }
    }
  }
  const auto points = static_cast<std::size_t>(steps) + 1;
  Progress progress("thresholds over restitution", static_cast<double>(curves.size() * points));
  tbb::parallel_for(std::size_t{0}, curves.size() * points, [&](std::size_t i) {
    ThresholdCurve& curve = curves[i / points];
    CurvePoint& point = curve.points[i % points];
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
