#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// How much of a list of thresholds simple formulas explain.
namespace ricochet::carrier_track::inline paper {

/// The threshold of a case, of the paper or computed.
struct ThresholdPoint {
  std::string id;
  double restitution;  ///< e, in [0, 1)
  double friction;     ///< mu, >= 0
  double disturbance;  ///< D [N]
  double threshold;    ///< w [rad/s], > 0
};

/// Errors of predicted thresholds, all as ln(predicted / threshold).
struct PredictionErrors {
  double rms;                       ///< root mean square
  std::optional<double> explained;  ///< share of the variance of ln w, <= 1; none if all are equal
  double worst;                     ///< the largest in size, with its sign
  std::string worst_id;             ///< the case it belongs to
};

/// `predicted` [rad/s] > 0, one for each point; at least one.
PredictionErrors errors_of(const std::vector<ThresholdPoint>& points,
                           const std::vector<double>& predicted);

/// A family of thresholds with parameters to fit, by least squares of ln w.
struct Formula {
  std::string words;
  std::vector<std::string> constants;  ///< their names
  /// The best parameters; nothing if the points do not determine them.
  std::function<std::optional<std::vector<double>>(const std::vector<ThresholdPoint>&)> fit;
  /// w [rad/s] at a point, whose threshold is not used.
  std::function<double(const std::vector<double>& constants, const ThresholdPoint&)> threshold;
};

/// With R = (1 - e) / (1 + e), from one parameter to four; in the last, S(F / P) is the least drive
/// over the pull P that sustains bouncing with friction F, and r stands for normal force over pull
/// (problems/carrier_track/sustained_bouncing.h). Friction and disturbance enter as exp(k μ) and
/// exp(d D), which are linear in ln w; if the points have only two frictions, (1 + k μ) would fit
/// equally well.
std::vector<Formula> all_formulas();

/// Of the above, w = c √R.
Formula square_root_formula();

/// Of the above, w = c Rᵖ.
Formula power_formula();

/// Of the above, w = c √R exp(k μ).
Formula friction_formula();

struct FormulaFit {
  std::vector<double> constants;
  PredictionErrors errors;
  /// Root mean square of the errors at points left out of the fit, one at a time; nothing if the
  /// others do not determine the parameters, or if the formula gives no threshold there.
  std::optional<double> left_out;
};

/// Nothing unless there are more points than parameters and they determine these.
std::optional<FormulaFit> fitted(const Formula& formula, const std::vector<ThresholdPoint>& points);

}  // namespace ricochet::carrier_track::inline paper
