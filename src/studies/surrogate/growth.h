#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/difference.h"
#include "src/report/json.h"
#include "src/studies/dynamics/lyapunov.h"
#include "src/studies/surrogate/grazes.h"

/// For how long a motion are gradients useful? Their growth with the window, and their behaviour
/// next to a graze.
namespace ricochet::studies::surrogate {

/// A motion driven at a rate [rad/s], the variable of the derivatives: the speed of the driver
/// plate or, for a shaken gap, the frequency of its shaking.
struct Driven {
  std::string name;
  carrier_track::Scene scene;
  bool shaken = false;

  double rate() const { return shaken ? scene.disturbance_frequency : scene.omega; }

  /// The surrogate at the rate x[0], for derivatives.h.
  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    auto now = carrier_track::lifted<Scalar>(scene);
    (shaken ? now.disturbance_frequency : now.omega) = x[0];
    auto watcher = watch.of(now);
    return carrier_track::objective(now, carrier_track::default_smoothing, watcher);
  }
};

/// The derivative of an impact: of the state that reaches the wall at a given phase of the driving.
struct Stretched {
  double time;    ///< [s]
  double length;  ///< [m s], hypot(position, velocity / rate) per rad/s of the rate
};

/// For each counted impact of a valid scene, by dual numbers through the simulation.
std::vector<Stretched> stretched_by_impact(const Driven& driven);

/// Rate [1/s] at which the lengths grow from the first tenth of the window on, by least squares of
/// their logarithms; nothing for fewer than three impacts.
std::optional<double> rate_of(const std::vector<Stretched>& impacts, double window);

/// One motion in one window.
struct GrowthCell {
  double turns;  ///< of the driving
  std::optional<double> rate;
  dynamics::Sensitivity sensitivity;
  double gradient;    ///< of the surrogate at the default smoothing parameter, per rad/s
  Trust trust;        ///< in a box 18 rad/s wide
  Difference blind;   ///< steps of a thousandth of the rate and less
  Difference within;  ///< the same, but no longer than a quarter of the reach

  /// Error of a difference relative to the larger of it and the gradient; 0 if both are 0.
  double error_of(const Difference& difference) const;
};

GrowthCell growth_of(const Driven& driven, double turns);

struct GrowthPlan {
  std::vector<double> speeds;  ///< [rad/s], of the paper's cases
  std::vector<double> turns;   ///< windows, rising
  GrazePlan grazes;
};

struct GrowthRow {
  Driven driven;
  std::vector<GrowthCell> cells;     ///< one for each window
  std::vector<Stretched> stretched;  ///< in the longest window
};

struct GrowthStudy {
  GrowthPlan plan;
  std::vector<GrowthRow> rows;  ///< the cases at each speed, then shaken gaps
  GrazeStudy grazes;
};

/// The benchmark scene "chaotic", and similar ones with another pull and restitution.
std::vector<Driven> shaken_gaps();

GrowthStudy study_growth(const GrowthPlan& plan);

/// A difference with a larger error gives no information on a gradient.
inline constexpr double useless = 0.1;

report::Json data_of(const GrowthStudy& study);

}  // namespace ricochet::studies::surrogate
