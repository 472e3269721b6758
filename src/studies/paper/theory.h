#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"

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
};

/// `predicted` [rad/s] > 0, one for each point; at least one.
PredictionErrors errors_of(const std::vector<ThresholdPoint>& points,
                           const std::vector<double>& predicted);

/// A family of thresholds, ln w = power ln R + ln c + the other constants times their factors, with
/// R = (1 - e) / (1 + e). Fitted by least squares of ln w.
struct Formula {
  std::string words;
  std::vector<std::string> constants;  ///< their names, c first
  double power;
  std::vector<double (*)(const ThresholdPoint&)> factors;  ///< of the constants; that of ln c is 1
};

/// From one constant to four. Friction and disturbance enter as exp(k μ) and exp(d D), which are
/// linear in ln w; if the points have only two frictions, (1 + k μ) would fit equally well.
std::vector<Formula> all_formulas();

/// Of the above, w = c √R.
Formula square_root_formula();

/// Of the above, w = c √R exp(k μ).
Formula friction_formula();

struct FormulaFit {
  std::vector<double> constants;
  PredictionErrors errors;
  /// Root mean square of the errors at points left out of the fit, one at a time; nothing if the
  /// others do not determine the constants.
  std::optional<double> left_out;
};

/// Nothing unless there are more points than constants and they determine these.
std::optional<FormulaFit> fitted(const Formula& formula, const std::vector<ThresholdPoint>& points);

/// Speed and acceleration prescribed by the track, equations (1)-(5), Figure 3.
struct TheoreticalMotion {
  double speed;         ///< [m/s]
  double acceleration;  ///< [m/s^2]
};

/// On the circular arcs BE and FD, equations (1)-(2): r w and r w^2.
TheoreticalMotion on_arc(double radius, double omega);

/// On the straight crossing EF, equations (3)-(5). `angle` = phi_2 - phi_1 in (-pi/2, pi/2) [rad]
/// is the angle of the driving plate from the point where the crossing is tangent to its arc: it
/// rises from 0 until the next plate takes over half way, and then runs from the negative back to
/// 0. Equation (5) agrees with (4) only if the normal and tangential parts enclose 90 degrees +
/// angle; this reading is used here.
TheoreticalMotion on_crossing(double radius, double omega, double angle);

/// The speed [rad/s] of a carrier about its plate's axis, V / r of equations (1) and (3), while the
/// plate turns steadily at `omega` [rad/s] > 0: the middle of every half turn of the plate has a
/// crossing, where the plate turns from -`angle` to +`angle` in (0, pi/4) [rad]; there the speed
/// rises to omega / cos^2(angle) half way. Five knots per crossing approximate that curve. The
/// profile covers `turns`.
std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns);

}  // namespace ricochet::carrier_track::inline paper
