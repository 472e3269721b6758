#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// How much of a list of thresholds a formula of one line explains.
namespace ricochet::studies::reproduction {

/// The threshold of a case, of the paper or computed.
struct ThresholdPoint {
  std::string id;
  double restitution;  ///< e, in [0, 1)
  double friction;     ///< mu, >= 0
  double disturbance;  ///< D [N]
  double threshold;    ///< w [rad/s], > 0
};

/// How far predicted thresholds are from points, all as ln(predicted / threshold).
struct PredictionErrors {
  double rms;                       ///< root mean square
  std::optional<double> explained;  ///< share of the variance of ln w, <= 1; none if all are equal
  double worst;                     ///< the largest in size, with its sign
  std::string worst_id;             ///< the case it belongs to
};

/// `predicted` [rad/s] > 0, one a point; at least one.
PredictionErrors errors_of(const std::vector<ThresholdPoint>& points,
                           const std::vector<double>& predicted);

/// A family of thresholds with constants to fit, by least squares of ln w.
struct Formula {
  std::string words;
  std::vector<std::string> constants;  ///< their names
  /// The best constants; nothing where the points do not determine them.
  std::function<std::optional<std::vector<double>>(const std::vector<ThresholdPoint>&)> fit;
  /// w [rad/s] at a point, whose threshold is not used.
  std::function<double(const std::vector<double>& constants, const ThresholdPoint&)> threshold;
};

/// With R = (1 - e) / (1 + e), from one constant to four; in the last, S(F / P) is the least drive
/// over the pull P that sustains bouncing with friction F, and r stands for normal force over pull
/// (problems/carrier_track/sustained_bouncing.h). Friction and disturbance enter as exp(k μ) and
/// exp(d D), which are linear in ln w; where the points have two frictions only, (1 + k μ) would
/// fit as well.
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
  /// Root mean square of the errors at points that the fit did not see, each left out in turn;
  /// nothing where the others do not determine the constants, or give it no threshold.
  std::optional<double> left_out;
};

/// Nothing unless there are more points than constants and they determine these.
std::optional<FormulaFit> fitted(const Formula& formula, const std::vector<ThresholdPoint>& points);

}  // namespace ricochet::studies::reproduction
